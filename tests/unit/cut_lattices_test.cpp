// A plate meets nodes alone. Where it goes through a lattice between two of them, no force says so: the watch does.
#include "run/cut_lattices.h"

#include <gtest/gtest.h>

#include "watched_run.h"

namespace furrow::test {
namespace {

struct Through {
  const char* name;
  Vec2 lower_left;  // m, of the plate
  double width, height;
  Vec2 of_plate, of_lattice;  // m/s
};

void PrintTo(const Through& through, std::ostream* out) { *out << through.name; }

// 6 x 4 nodes, 20 mm apart.
Scene scene_of(const Through& t) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 6, 4, 0.02);
  l.structural = link_kind(1e4, 1);
  l.shear = link_kind(5e3, 1);
  for (int node = 0; node < 24; ++node) l.node.push_back(node_setting(node / 4, node % 4, {}, t.of_lattice));
  if (t.of_lattice == Vec2{}) l.fixed_rows = {0, 1, 2, 3, 4, 5};
  scene.lattice = {l};
  scene.plate = {plate(t.lower_left, t.width, t.height, t.of_plate)};
  return scene;
}

class CutLattices : public testing::TestWithParam<Through> {};
INSTANTIATE_TEST_SUITE_P(
    Ways, CutLattices,
    testing::Values(Through{"falls over an upright bar", {0.022, -0.3}, 0.016, 0.25, {}, {0, -0.5}},
                    Through{"comes to a lying bar", {0.1, 0.022}, 0.25, 0.016, {}, {0.5, 0}},
                    Through{"a bar is pushed into it", {-0.3, 0.022}, 0.25, 0.016, {0.5, 0}, {}},
                    Through{"a bar comes to it obliquely", {-0.17, 0.0345}, 0.02, 0.014, {0.3, 0.014}, {}},
                    Through{"a small plate goes through it", {-0.1, 0.025}, 0.005, 0.01, {1, 0}, {}}),
    [](const auto& one) { return "Of" + std::to_string(one.index); });

TEST_P(CutLattices, AreSaid) {
  const Scene scene = scene_of(GetParam());
  const WatchedRun r = watched(scene, "verlet", 1e-4, 0.6);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  EXPECT_EQ(r.extremes.plate[0].force, 0) << "nothing else tells";
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).verdict(), Verdict::warned);
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).where, "plate 0 and lattice 0");
  EXPECT_TRUE(watched(allowing_all(scene), "verlet", 1e-4, 0.6).warnings.empty());
}

// Another lattice elsewhere, with nodes close together, makes no plate longer than the segments that it meets.
TEST(CutLattice, IsSaidBesideAFinerOne) {
  Scene scene = empty_scene();
  Lattice coarse = lattice({0, 0}, 3, 3, 0.02), fine = lattice({1, 0}, 2, 2, 0.0015);
  coarse.fixed_rows = {2}, fine.fixed_rows = {0};
  coarse.structural = fine.structural = link_kind(1e3, 1);
  scene.lattice = {coarse, fine};
  scene.plate = {plate({0.008, -0.0051}, 0.004, 5e-5, {0, 4})};
  EXPECT_EQ(watched(scene, "verlet", 1e-6, 0.005).of(WatchKind::crossing_lattices).verdict(), Verdict::warned);
}

// A plate that pushes nodes aside stands in the lattice's outline as it bends, and goes through none of its segments.
TEST(CutLattice, ThatBendRoundAPlateAreNot) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 10, 3, 0.01);
  l.fixed_rows = {0};
  l.structural = link_kind(1e4, 2);
  l.shear = link_kind(5e3, 2);
  scene.lattice = {l};
  scene.plate = {plate({-0.03, 0.055}, 0.01, 0.06, {0.1, 0})};
  const WatchedRun r = watched(allowing_all(scene), "pece", 5e-5, 0.3);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  ASSERT_GT(r.extremes.plate[0].force, 1) << "it was pushed";
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).worst, 0);
}

// A link from (0, 0) to (1, 1), and plates where it goes through two opposite sides, round a corner, and beside.
TEST(CutLattice, GoesThroughTwoOppositeSides) {
  struct Place {
    Vec2 lower_left;
    double width, height;
    int cuts;
  };
  for (const auto& [lower_left, width, height, cuts] :
       {Place{{0.4, 0.3}, 0.2, 0.4, 1}, Place{{0.3, 0.4}, 0.4, 0.2, 1}, Place{{0.4, 0.55}, 0.2, 0.4, 0},
        Place{{0.55, 0.4}, 0.4, 0.2, 0}, Place{{0.4, 0.7}, 0.2, 0.2, 0}, Place{{0.9, 0.8}, 0.4, 0.4, 0}}) {
    for (const bool torn : {false, true}) {
      Scene scene = empty_scene();
      Lattice l = lattice({0, 0}, 1, 2, 1);
      l.structural = link_kind(1, 0);
      l.node = {node_setting(0, 1, {0, 1})};
      if (torn) l.link = {{.from = {0, 0}, .to = {0, 1}, .torn = true}};
      scene.lattice = {l};
      scene.plate = {plate(lower_left, width, height)};
      const System system(scene);
      EXPECT_EQ(cut_by_plates(system, 0, system.initial_state()).pairs, torn ? 0 : cuts)
          << lower_left.x << ", " << lower_left.y << (torn ? ", torn" : "");
    }
  }
}

// ---- discs through a link of the border that is torn ----

TEST(TornBorder, ADiscThatComesInThroughItIsSaid) {
  for (const bool new_faces : {false, true}) {
    Scene scene = empty_scene();
    Lattice l = lattice({0, 0}, 4, 8, 0.02);
    l.structural = link_kind(1e5, 1);
    l.shear = link_kind(5e4, 1);
    l.link = {{.from = {3, 3}, .to = {3, 4}, .torn = true}};
    scene.lattice = {l};
    scene.disc = {disc({0.07, 0.075}, 0.008, {0, -0.2})};
    scene.model.new_faces = new_faces;
    const WatchedRun r = watched(scene, "verlet", 1e-4, 0.2);
    const Watched& crossing = r.of(WatchKind::crossing_lattices);
    EXPECT_EQ(crossing.verdict(), new_faces ? Verdict::kept : Verdict::warned);
    EXPECT_EQ(crossing.where.ends_with(", through its torn border"), !new_faces) << crossing.where;
  }
}

}  // namespace
}  // namespace furrow::test
