// The watch over a run with lattices: what driven nodes pass, and what of the energy is the rounding of places.
#include <gtest/gtest.h>

#include "watched_run.h"

namespace furrow {
namespace {

using namespace test;

TEST(Validity, ADrivenLatticeThatStepsOverADiscEndsTheRun) {
  Scene scene = empty_scene();
  scene.disc = {disc({0.0225, 0}, 1e-3)};
  Lattice tool = lattice({0, -0.02}, 5, 1, 0.01);
  tool.drive = {{.columns = {0}, .velocity = {5, 0}}};
  scene.lattice = {tool};
  const WatchedRun r = watched(scene, "pece", 1e-3, 0.01);  // 5 mm in a step
  EXPECT_EQ(r.end.ending, Ending::diverged);
  EXPECT_EQ(r.end.reason.substr(0, 43), "disc 0 and lattice 0 met within one step of");
  tool.drive[0].velocity = {0.5, 0};  // half a radius: it pushes the disc
  scene.lattice = {tool};
  EXPECT_EQ(watched(scene, "pece", 1e-3, 0.01).end.ending, Ending::finished);
}

TEST(Validity, TheArrivalIsJudgedByTheSpeedOfDrivenNodesToo) {
  Scene scene = empty_scene();
  scene.disc = {disc({-0.1, 0.013}, 0.1)};
  scene.lattice = {lattice({0, -0.5}, 11, 3, 0.1)};
  scene.lattice[0].drive = {{.columns = {0, 1, 2}, .velocity = {-3, 0}}};
  EXPECT_EQ(watched(scene, "pece", 1e-5, 2e-5).of(WatchKind::arrival).where, "at 3 m/s");
}

// 1e4 N/m: its rounding is not 1e-10 of an energy, since there is none.
TEST(Validity, RoundOffOfALatticeInWhichNothingHappensIsNoEnergy) {
  for (const double place : {0.0, 0.3, 1000.3}) {
    for (const double driven : {0.0, 30.0}) {
      Scene scene = empty_scene();
      Lattice l = lattice({place, place}, 5, 3, 0.01);
      l.node_mass = 0.02;
      l.structural = l.shear = l.bending = link_kind(1e4, 1, infinity);
      if (driven > 0) l.drive = {{.columns = {0, 1, 2}, .velocity = {driven, 0}}};
      scene.lattice = {l};
      const WatchedRun r = watched(scene, "pece", 1e-4, 0.1);
      EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
      EXPECT_EQ(r.of(WatchKind::energy_made).worst, 0) << place << ' ' << driven;
      EXPECT_EQ(r.of(WatchKind::energy_lost).worst, 0) << place << ' ' << driven;
    }
  }
}

// A stretch of a billionth of a spacing, 1e-17 m^2 * 1e4 N/m, is one: what a method makes of it is seen.
TEST(Validity, AMotionOfABillionthOfTheSpacingIsWatched) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 2, 2, 0.01);
  l.node_mass = 0.02;
  l.fixed_rows = {0};
  l.structural = l.shear = link_kind(1e4, 0, infinity);
  l.node = {{.row = 1, .column = 0, .displacement = {1e-11, 0}}};
  scene.lattice = {l};
  const WatchedRun r = watched(scene, "ab2", 1e-3, 0.5);  // 0.7 of 1/omega
  EXPECT_NE(r.end.ending, Ending::finished);
  EXPECT_EQ(r.of(WatchKind::energy_made).verdict(), Verdict::broken);
}

}  // namespace
}  // namespace furrow
