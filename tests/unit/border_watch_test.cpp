// A centre that crosses the border of a lattice is seen whether or not the disc touches it.
#include <gtest/gtest.h>

#include "watched_run.h"

namespace furrow::test {
namespace {

double through(const Scene& scene, double step, double end) {
  const WatchedRun r = watched(allowing_all(scene), "pece", step, end);
  EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  return r.of(WatchKind::through_lattices).worst;
}

// 5 x 3 nodes 10 mm apart, and a disc in front of them at this height, which comes at 1 m/s.
Scene disc_before_lattice(double radius, double height, int points) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 5, 3, 0.01);
  l.structural = l.shear = l.bending = link_kind(1e4, 1);
  l.auxiliary_points = points;
  scene.lattice = {l};
  scene.disc = {disc({-0.005, height}, radius, {1, 0})};
  return scene;
}

TEST(BorderWatch, ADiscBetweenTwoPointsIsSeenOnBothSides) {
  EXPECT_EQ(through(disc_before_lattice(2e-4, 0.0255, 9), 1e-5, 0.05), 2) << "0.5 mm from the next point";
  EXPECT_EQ(through(disc_before_lattice(2e-3, 0.0275, 1), 1e-4, 0.05), 2) << "2.5 mm from the next point";
  EXPECT_EQ(through(disc_before_lattice(2e-4, 0.0255, 9), 1e-5, 0.02), 1) << "it is still inside";
}

TEST(BorderWatch, ItEndsTheRunUnlessTheSceneAllowsIt) {
  const WatchedRun r = watched(disc_before_lattice(2e-4, 0.0255, 9), "pece", 1e-5, 0.05);
  EXPECT_EQ(r.end.ending, Ending::invalid);
  EXPECT_NE(r.end.reason.find("[allow] through_lattices"), std::string::npos) << r.end.reason;
  EXPECT_NEAR(r.end.time, 0.005, 2e-5) << "where its centre comes to the border";
}

// Rows three times as far apart as the spacing says: the points are 3 mm apart, not 1 mm.
TEST(BorderWatch, OfAStretchedLatticeTheSegmentsAreAskedAsTheyAre) {
  Scene scene = disc_before_lattice(1e-3, 0.0465, 9);
  Lattice l = lattice({0, 0}, 4, 3, 0.01);
  l.structural = l.shear = l.bending = link_kind(1, 0.1);
  l.node_mass = 10;
  for (int row = 1; row < 4; ++row)
    for (int column = 0; column < 3; ++column) l.node.push_back(node_setting(row, column, {0, 0.02 * row}));
  scene.lattice = {l};
  EXPECT_EQ(through(scene, 1e-4, 0.05), 2);
}

TEST(BorderWatch, ALatticeThatMovesOverADiscIsSeen) {
  for (const bool driven : {true, false}) {
    Scene scene = empty_scene();
    Lattice l = lattice({0, 0}, 5, 1, 0.01);
    l.structural = link_kind(1e4, 1);
    if (driven) l.drive = {{.columns = {0}, .velocity = {1, 0}}};
    for (int row = 0; row < 5 && !driven; ++row) l.node.push_back(node_setting(row, 0, {}, {1, 0}));
    scene.lattice = {l};
    scene.disc = {disc({0.01, 0.0255}, 2e-4)};
    EXPECT_EQ(through(scene, 1e-5, 0.02), 1) << driven;
    scene.disc = {disc({0.01, 0.0405}, 2e-4)};
    EXPECT_EQ(through(scene, 1e-5, 0.02), 0) << "it goes past the last node";
  }
}

// The upper of the two links is torn at the start.
TEST(BorderWatch, ATornLinkIsAGap) {
  for (const double height : {0.055, 0.125}) {
    Scene scene = empty_scene();
    Lattice l = lattice({0, 0}, 3, 1, 0.1);
    l.structural = link_kind(1e3, 1, 10);
    l.node = {node_setting(2, 0, {0, 0.05})};
    scene.lattice = {l};
    scene.disc = {disc({-0.1, height}, 1e-3, {1, 0})};
    EXPECT_EQ(through(scene, 1e-4, 0.2), height < 0.1 ? 1 : 0) << height;
  }
}

// Column 0 is torn off at the start and flies away upward: the face at x = 0.1 m was no border before.
TEST(BorderWatch, AFaceMadeByATearIsWatched) {
  Scene scene = empty_scene();
  scene.model.new_faces = true;
  Lattice l = lattice({0, 0}, 5, 4, 0.1);
  l.fixed_columns = {1, 2, 3};
  l.structural = l.shear = link_kind(1e3, 0, 10);
  for (int row = 0; row < 5; ++row) l.node.push_back(node_setting(row, 0, {-0.05, 0}, {0, 20}));
  scene.lattice = {l};
  scene.disc = {disc({-0.2, 0.225}, 1e-3, {0.5, 0})};
  EXPECT_EQ(through(scene, 1e-4, 0.7), 1) << "into what is left";
  EXPECT_EQ(through(scene, 1e-4, 1.1), 2) << "and out of it";
}

// 20 steps from one disc to the next: pairs are collected more than once.
TEST(BorderWatch, NoneOfAHundredIsMissed) {
  Scene scene = disc_before_lattice(2e-4, 0.0255, 9);
  scene.disc.clear();
  for (int k = 0; k < 100; ++k)
    scene.disc.push_back(disc({-0.005 - 1e-3 * (k / 4), 0.0055 + 0.01 * (k % 4)}, 2e-4, {1, 0}));
  EXPECT_EQ(through(scene, 5e-5, 0.06), 200);
}

TEST(BorderWatch, ADiscThatSlidesAlongOrIsThrownBackCrossesNone) {
  Scene scene = disc_before_lattice(2e-3, 0.0275, 9);
  scene.disc[0].velocity = {0.1, 0};
  EXPECT_EQ(through(scene, 1e-5, 0.1), 0);
  scene.disc = {disc({-0.0019, -0.01}, 2e-3, {0, 1})};
  EXPECT_EQ(through(scene, 1e-5, 0.05), 0);
}

}  // namespace
}  // namespace furrow::test
