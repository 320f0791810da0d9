// What passes through something between two steps is seen, wherever its places before and after the step are.
#include <gtest/gtest.h>

#include "soft_scene.h"
#include "watched_run.h"

namespace furrow::test {
namespace {

// 9 mm a step: before it and after it the disc touches the plate, 1 mm thick, from the two sides.
TEST(Passing, ADiscWhoseCentreIsInAPlateAtNoEndOfAStepHasGoneThrough) {
  int through = 0;
  for (int place = 0; place < 9; ++place) {
    Scene scene = soft_scene();
    scene.disc = {disc({0, 0}, 0.01, {9, 0})};
    scene.plate = {plate({0.0105 + 1e-3 * place, -0.05}, 0.001, 0.1)};
    const WatchedRun r = watched(scene, "pece", 1e-3, 0.02);
    const bool gone = r.y[0] > scene.plate[0].left_edge + 0.001;
    through += r.end.ending != Ending::finished ? 1 : 0;
    if (gone) {
      EXPECT_NE(r.end.ending, Ending::finished) << "place " << place;
    }
  }
  EXPECT_GT(through, 4) << "or nothing was tried";
}

// So soft that nothing stops it: 2 mm a step, the plate is 1 mm thick.
TEST(Passing, ANodeThatLeavesAPlateByTheOtherFaceHasGoneThrough) {
  for (int place = 0; place < 10; ++place) {
    Scene scene = soft_scene();
    for (Material& m : scene.material) m.young = 10;
    Lattice l = lattice({0, 0}, 1, 1, 0.05);
    l.node = {node_setting(0, 0, {}, {1, 0})};
    scene.lattice = {l};
    scene.plate = {plate({0.0101 + 2e-4 * place, -0.1}, 1e-3, 0.2)};
    EXPECT_NE(watched(scene, "pece", 2e-3, 0.04).end.ending, Ending::finished) << "place " << place;
  }
}

TEST(Passing, ALatticeDoesNotStepOverADisc) {
  Scene scene = soft_scene();
  scene.disc = {disc({0.0303, 0.005}, 1e-4)};
  Lattice l = lattice({0, 0}, 2, 2, 0.01);
  l.structural = {1e3, 0.1};
  l.auxiliary_points = 0;
  for (const int row : {0, 1})
    for (const int column : {0, 1}) l.node.push_back(node_setting(row, column, {}, {9, 0}));
  scene.lattice = {l};
  const WatchedRun r = watched(scene, "pece", 1e-3, 0.02);
  EXPECT_EQ(r.end.ending, Ending::diverged);
  EXPECT_NE(r.end.reason.find("met within one step"), std::string::npos) << r.end.reason;
}

// 3 mm a step, the disc of 1 mm is 1 m away, beside the way or on it: only what meets it has to go in smaller steps.
TEST(Passing, ADiscBesideTheWayLimitsNoLattice) {
  const auto ending = [](Vec2 place) {
    Scene scene = soft_scene();
    scene.disc = {disc(place, 1e-3)};
    Lattice l = lattice({0, 0}, 1, 2, 0.05);
    l.structural = {1e3, 0.1};
    l.node = {node_setting(0, 0, {}, {3, 3}), node_setting(0, 1, {}, {3, 3})};
    scene.lattice = {l};
    return watched(scene, "pece", 1e-3, 0.03).end.ending;
  };
  EXPECT_EQ(ending({1, 1}), Ending::finished);
  EXPECT_EQ(ending({0.03, -0.002}), Ending::finished) << "below it from the start";
  EXPECT_EQ(ending({0.04, 0.05}), Ending::finished) << "its left end passes 10 mm beside it";
  EXPECT_EQ(ending({0.07, 0.055}), Ending::diverged) << "between two places that it comes to";
}

// Two discs of 10 mm at 30 m/s, 15 mm a step.
Ending of_two(Vec2 place, Vec2 velocity, Vec2 other_velocity) {
  Scene scene = soft_scene();
  scene.disc = {disc({0, 0}, 0.01, velocity), disc(place, 0.01, other_velocity)};
  return watched(scene, "verlet", 5e-4, 0.01).end.ending;
}

TEST(Passing, OnlyWhatMeetsHasToGoInSmallSteps) {
  EXPECT_EQ(of_two({1, 1}, {30, 0}, {}), Ending::finished) << "beside the way";
  EXPECT_EQ(of_two({-0.021, 0}, {30, 0}, {}), Ending::finished) << "behind it";
  EXPECT_EQ(of_two({0.021, 0}, {30, 30}, {30, 30}), Ending::finished) << "together";
  EXPECT_EQ(of_two({0.3, 0.3}, {30, 0}, {0, 30}), Ending::finished) << "along two ways apart";
  EXPECT_EQ(of_two({0.2, 0.2}, {30, 0}, {30, -30}), Ending::finished) << "it is past before the other comes";
  EXPECT_NE(of_two({0.202, 0.003}, {30, 0}, {}), Ending::finished) << "on the way";
  EXPECT_NE(of_two({0.202, 0.202}, {30, 0}, {0, -30}), Ending::finished) << "at one place at one time";
}

TEST(Passing, ADiscThatIsAloneMayGoAsFarAsItLikes) {
  Scene scene = soft_scene();
  scene.disc = {disc({0, 0}, 0.01, {3, 0})};
  scene.wall = {wall({0, -0.011}, {0, 1})};
  scene.plate = {plate({-0.1, 0.02}, 0.05, 0.1)};
  const WatchedRun r = watched(scene, "verlet", 5e-3, 0.1);
  EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  scene.disc[0].velocity = {3, -1};
  EXPECT_NE(watched(scene, "verlet", 5e-3, 0.1).end.ending, Ending::finished) << "towards the wall";
  scene.disc[0].velocity = {-6, 4};
  EXPECT_NE(watched(scene, "verlet", 5e-3, 0.1).end.ending, Ending::finished) << "through the plate";
}

// No impact can come where no two can meet.
TEST(Passing, ADiscThatIsAloneIsNotWarnedOfImpacts) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.01, {3, 0})};
  EXPECT_TRUE(watched(scene, "verlet", 0.02, 0.1).warnings.empty());
  scene.disc.push_back(disc({5, 5}, 0.01));
  EXPECT_FALSE(watched(scene, "verlet", 0.02, 0.1).warnings.empty());
}

TEST(Passing, NodesThatLeaveEachOtherByTheirSpacingInAStepHaveBlownUp) {
  for (const double other : {11.0, 8.0, -10.0}) {
    Scene scene = soft_scene();
    Lattice l = lattice({0, 0}, 1, 2, 0.01);
    l.structural = link_kind(1e-3, 0);
    l.node = {node_setting(0, 0, {}, {11, 0}), node_setting(0, 1, {}, {other, 0})};
    scene.lattice = {l};
    const WatchedRun r = watched(scene, "verlet", 1e-3, 2e-3);
    EXPECT_EQ(r.end.ending, other < 0 ? Ending::diverged : Ending::finished) << other << ": " << r.end.reason;
  }
}

// The disc is 9 mm behind a lattice that flies away from it.
TEST(Passing, ALatticeMayFlyAwayFromATinyDisc) {
  Scene scene = empty_scene();
  scene.disc = {disc({-0.009, 0.01}, 1e-4)};
  Lattice l = lattice({0, 0}, 3, 3, 0.01);
  l.structural = link_kind(1e3, 0);
  for (int k = 0; k < 9; ++k) l.node.push_back(node_setting(k / 3, k % 3, {}, {4, 0}));
  scene.lattice = {l};
  const WatchedRun r = watched(scene, "verlet", 1e-4, 0.01);
  EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
}

TEST(Passing, DrivenNodesDoNotStepOverADisc) {
  for (const double height : {0.0, 0.02}) {
    Scene scene = soft_scene();
    scene.disc = {disc({0.0503, height}, 1e-4)};
    Lattice l = lattice({0, 0}, 1, 2, 0.01);
    l.drive = {{.columns = {0, 1}, .velocity = {1, 0}}};
    scene.lattice = {l};
    const WatchedRun r = watched(scene, "verlet", 1e-3, 0.1);
    EXPECT_EQ(r.end.ending, height == 0 ? Ending::diverged : Ending::finished) << r.end.reason;
  }
}

// One that stands and one that comes at 1 m/s: strands that are parallel, and a single node through a block.
TEST(Passing, LatticesThatPassThroughEachOtherAreCounted) {
  for (const bool block : {false, true}) {
    Scene scene = soft_scene();
    Lattice stands = block ? lattice({0, 0}, 3, 3, 0.01) : lattice({0, 0}, 2, 1, 0.01);
    stands.structural = {1e3, 0.1};
    Lattice comes = block ? lattice({0.0503, 0.0153}, 1, 1, 0.01) : lattice({0.0503, 0}, 2, 1, 0.01);
    comes.structural = {1e3, 0.1};
    comes.node = {node_setting(0, 0, {}, {-1, 0})};
    if (!block) comes.node.push_back(node_setting(1, 0, {}, {-1, 0}));
    scene.lattice = {stands, comes};
    const WatchedRun r = watched(scene, "pece", 1e-4, 0.1);
    EXPECT_EQ(r.of(WatchKind::crossing_lattices).worst, block ? 2 : 4)
        << "into and out of it; each node through the other";
    EXPECT_FALSE(r.warnings.empty());
  }
}

TEST(Passing, LatticesSideBySideDoNotPass) {
  Scene scene = soft_scene();
  Lattice stands = lattice({0, 0}, 3, 3, 0.01), comes = lattice({0.05, 0.03}, 3, 3, 0.01);
  for (Lattice* l : {&stands, &comes}) l->structural = {1e3, 0.1};
  for (int node = 0; node < 9; ++node) comes.node.push_back(node_setting(node / 3, node % 3, {}, {-1, 0}));
  scene.lattice = {stands, comes};
  const WatchedRun r = watched(scene, "pece", 1e-4, 0.1);
  EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  EXPECT_EQ(r.of(WatchKind::crossing_lattices).worst, 0);
}

}  // namespace
}  // namespace furrow::test
