// What the watch over a run does not see yet, or sees where nothing is.
#include "tests/expected_to_fail/expected_to_fail.h"
#include "tests/unit/watched_run.h"

namespace furrow::test {
namespace {

// The middle node of nine stands beyond its right neighbour: two inner links cross the border, the corners of no cell go
// round the wrong way.
TEST_F(ExpectedToFail, ACellFoldedLikeABowTieIsNoticed) {
  mended_in("tests/unit/crossing_lattices_test.cpp");
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 3, 3, 0.1);
  l.structural = link_kind(1e-6, 0);
  l.node = {node_setting(1, 1, {0.115, 0})};
  scene.lattice = {l};
  const WatchedRun r = watched(scene, "verlet", 1e-3, 0.2);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  EXPECT_RIGHT(r.of(WatchKind::crossing_lattices).worst > 0) << "links of one lattice that cross are noticed";
}

// Nothing else is in the scene, so nothing can be passed unseen.
TEST_F(ExpectedToFail, ADiscThatIsAloneMayGoAsFarAsItLikes) {
  mended_in("tests/unit/passing_test.cpp");
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.01, {3, 0})};
  const WatchedRun r = watched(scene, "verlet", 5e-3, 0.1);
  EXPECT_RIGHT(r.end.ending == Ending::finished) << "it ends well; it ended because " << r.end.reason;
}

// The disc is 9 mm behind a lattice that flies away from it.
TEST_F(ExpectedToFail, ALatticeMayFlyAwayFromATinyDisc) {
  mended_in("tests/unit/passing_test.cpp");
  Scene scene = empty_scene();
  scene.disc = {disc({-0.009, 0.01}, 1e-4)};
  Lattice l = lattice({0, 0}, 3, 3, 0.01);
  l.structural = link_kind(1e3, 0);
  for (int k = 0; k < 9; ++k) l.node.push_back(node_setting(k / 3, k % 3, {}, {4, 0}));
  scene.lattice = {l};
  const WatchedRun r = watched(scene, "verlet", 1e-4, 0.01);
  EXPECT_RIGHT(r.end.ending == Ending::finished) << "it ends well; it ended because " << r.end.reason;
}

// What the spring holds after slip may be more than the limit if the damper pushes the other way: it makes energy that
// is booked as stiffening and as negative heat.
TEST_F(ExpectedToFail, EnergyOfAnOverfullTangentialSpringIsNoticed) {
  mended_in("tests/unit/energy_watch_test.cpp");
  Scene scene = empty_scene();
  scene.material[0].young = 2e7;
  scene.model.law = ForceLaw::rescaled_mindlin;
  scene.model.after_slip = AfterSlip::less_viscous;
  scene.contact.friction = 0.5;
  scene.contact.damping_factor = 2;
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.disc = {disc({0, 0.01}, 0.01, {0.107, -0.169}, 10)};
  const WatchedRun r = watched(allowing_all(scene), "pece", 5e-6, 0.025);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  EXPECT_RIGHT(r.of(WatchKind::energy_made).worst > 0.01) << "kinetic and elastic energy grow to many times the start";
}

}  // namespace
}  // namespace furrow::test
