// Lattices do not touch each other or themselves, and may turn inside out: where they do, that is said.
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/read.h"
#include "watched_run.h"

namespace furrow {
namespace {

using namespace test;

// Two by two nodes that fly from the right through as many fixed ones.
Scene two_lattices() {
  Scene scene = empty_scene();
  Lattice still = lattice({0, 0}, 3, 3, 0.1), flies = lattice({0.35, 0.05}, 2, 2, 0.1);
  still.fixed_columns = {0, 1, 2};
  for (int k = 0; k < 4; ++k) flies.node.push_back(node_setting(k / 2, k % 2, {}, {-1, 0}));
  still.name = "still", flies.name = "flies";
  scene.lattice = {still, flies};
  return scene;
}

TEST(CrossingLattices, OfTwoAreNoticed) {
  const WatchedRun r = watched(two_lattices(), "verlet", 1e-3, 1);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  ASSERT_LT(*std::max_element(r.y.begin(), r.y.begin() + 4), 0) << "all of it has passed";
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).verdict(), Verdict::warned);
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).where, "lattice still and lattice flies");
  EXPECT_EQ(r.warnings.size(), 1u);
}

TEST(CrossingLattices, OfTheHalvesOfATornOneAreNoticed) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 3, 4, 0.1);
  l.fixed_columns = {0, 1};
  l.structural = l.shear = link_kind(1e3, 0, 10);
  for (int k = 0; k < 6; ++k) l.node.push_back(node_setting(k / 2, 2 + k % 2, {0.05, 0.05}, {-1, 0}));
  scene.lattice = {l};
  const WatchedRun r = watched(scene, "verlet", 1e-3, 1);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  ASSERT_EQ(r.tears, 7) << "3 structural and 4 shear links between the halves";
  ASSERT_LT(*std::max_element(r.y.begin(), r.y.begin() + 6), 0) << "all of it has passed";
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).verdict(), Verdict::warned);
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).where, "lattice 0 and itself");
  EXPECT_TRUE(watched(allowing_all(scene), "verlet", 1e-3, 1).warnings.empty());
}

// The right column of a whole lattice, pushed through the left one: its links are then as long as before.
Scene pushed_through(int rows) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, rows, 2, 0.1);
  l.fixed_columns = {0};
  l.structural = link_kind(10, 0);
  for (int k = 0; k < rows; ++k) l.node.push_back(node_setting(k, 1, {}, {-1, 0}));
  scene.lattice = {l};
  return scene;
}

TEST(CrossingLattices, CellsThatTurnInsideOutAreNoticed) {
  const WatchedRun r = watched(pushed_through(3), "verlet", 1e-3, 0.15);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  ASSERT_LT(r.y[0], 0);
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).verdict(), Verdict::warned);
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).worst, 2);
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).where, "cell at row 0, column 0 of lattice 0 is inside out");
  EXPECT_EQ(watched(pushed_through(1), "verlet", 1e-3, 0.15).of(WatchKind::crossing_lattices).worst, 0)
      << "a single link has no inside";
}

// The middle node of nine stands beyond its right neighbour: two inner links cross the border, the corners of no cell go
// round the wrong way.
TEST(CrossingLattices, ACellFoldedLikeABowTieIsNoticed) {
  const auto worst = [](Vec2 moved) {
    Scene scene = empty_scene();
    Lattice l = lattice({0, 0}, 3, 3, 0.1);
    l.structural = link_kind(1e-6, 0);
    l.node = {node_setting(1, 1, moved)};
    scene.lattice = {l};
    const WatchedRun r = watched(scene, "verlet", 1e-3, 0.2);
    EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
    return r.of(WatchKind::crossing_lattices).worst;
  };
  EXPECT_EQ(worst({0.115, 0}), 2);
  EXPECT_EQ(worst({0, -0.115}), 2);
  EXPECT_GT(worst({0.115, 0.115}), 0);
  EXPECT_EQ(worst({0.09, 0.02}), 0) << "bent, but no side crosses another";
}

// The end of a chain goes through its middle, and 16 steps later its last link has left that at the end.
TEST(CrossingLattices, AChainThatCrossesItselfForAShortTimeIsNoticed) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 1, 4, 0.1);
  l.structural = link_kind(1e-6, 0);
  l.node = {node_setting(0, 2, {-0.05, 0.1}), node_setting(0, 3, {-0.25, 0.025}, {0, -6})};
  scene.lattice = {l};
  const WatchedRun r = watched(scene, "verlet", 1e-3, 0.049);
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).verdict(), Verdict::warned);
}

// A chain whose end is thrown across its middle.
TEST(CrossingLattices, AChainThatCrossesItselfIsNoticed) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 1, 4, 0.1);
  l.node = {node_setting(0, 2, {-0.05, 0.1}), node_setting(0, 3, {-0.25, 0.05}, {0, -1})};
  scene.lattice = {l};
  const WatchedRun r = watched(scene, "verlet", 1e-3, 0.15);
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).verdict(), Verdict::warned);
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).where, "lattice 0 and itself");
}

TEST(CrossingLattices, ThatAreApartOrWholeAreNot) {
  Scene scene = two_lattices();
  for (NodeSetting& s : scene.lattice[1].node) s.velocity = {};
  EXPECT_EQ(watched(scene, "verlet", 1e-3, 1).of(WatchKind::crossing_lattices).worst, 0);
}

// What a run would warn of at its start, `check` says before it.
TEST(CrossingLattices, TheStartIsJudgedAsTheRunWouldJudgeIt) {
  const auto warnings = [](int rows, int columns, const NodeSetting& moved) {
    Scene scene = empty_scene();
    Lattice l = lattice({0, 0}, rows, columns, 0.1);
    l.structural = link_kind(10, 0);
    l.node = {moved};
    scene.lattice = {l};
    std::vector<std::string> found = scene_warnings(scene);
    std::erase_if(found, [](const std::string& w) { return !w.starts_with("lattice[0]: its "); });
    const bool at_run = watched(scene, "verlet", 1e-6, 1e-6).of(WatchKind::crossing_lattices).worst > 0;
    EXPECT_EQ(at_run, !found.empty()) << rows << " x " << columns;
    return found;
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(warnings(3, 3, node_setting(2, 2, {-0.05, -0.05})), Lines{});
  EXPECT_EQ(
      warnings(3, 3, node_setting(2, 2, {-0.15, -0.15})),
      Lines{"lattice[0]: its cell at row 1, column 1 is inside out: its links know lengths alone and hold it there"});
  EXPECT_EQ(
      warnings(2, 3, node_setting(1, 1, {0.15, 0})),
      Lines{"lattice[0]: its cell at row 0, column 1 is folded over: its links know lengths alone and hold it there"});
  EXPECT_EQ(warnings(1, 5, node_setting(0, 4, {-0.25, 0.1})), Lines{});
  EXPECT_EQ(warnings(1, 5, node_setting(0, 0, {0.15, 0.02})), Lines{});
}

}  // namespace
}  // namespace furrow
