// What is in each other only between the ends of a step is seen, on any way and whatever moves; what only touches is not.
#include <gtest/gtest.h>

#include "soft_scene.h"
#include "watched_run.h"

namespace furrow::test {
namespace {

// 0.9 m a step: a disc of 1 m and one of 10 mm that it grazes; two of 10 mm at 0.99 of that, along each axis.
TEST(UnseenMeeting, ADiscStepsOverNoneHoweverSmallAndNotOnASlant) {
  Scene large = soft_scene();
  large.disc = {disc({-5.85, 0}, 1, {900, 0}), disc({0, 0.93}, 0.01)};
  EXPECT_EQ(watched(large, "verlet", 1e-3, 0.02).end.ending, Ending::diverged);
  Scene slanted = soft_scene();
  slanted.disc = {disc({-0.05445, -0.05445}, 0.01, {9.9, 9.9}), disc({0.06455, 0.04435}, 0.01, {-9.9, -9.9})};
  EXPECT_EQ(watched(slanted, "verlet", 1e-3, 0.02).end.ending, Ending::diverged);
}

// The plate moves by 1 m a step, its sides are 50 mm and 10 m.
TEST(UnseenMeeting, APlateStepsOverNoDiscThatRests) {
  for (const double left : {0.01, -0.01, 0.11}) {
    Scene scene = soft_scene();
    scene.disc = {disc({0, 0}, 0.1)};
    scene.plate = {plate({left, -1.5}, 0.05, 0.05)};
    scene.plate[0].velocity = {0, 1000};
    scene.plate[0].name = "tool";
    const WatchedRun r = watched(scene, "verlet", 1e-3, 0.003);
    EXPECT_EQ(r.end.ending, left == 0.11 ? Ending::finished : Ending::diverged) << left;
    EXPECT_EQ(r.end.reason.find("disc 0 and plate tool met"), left == 0.11 ? std::string::npos : 0u) << r.end.reason;
  }
  Scene corner = soft_scene();
  corner.disc = {disc({0, 0}, 0.01)};
  corner.plate = {plate({-105, -90}, 100, 100)};
  corner.plate[0].velocity = {15000, -15000};
  EXPECT_EQ(watched(corner, "verlet", 1e-3, 0.003).end.ending, Ending::diverged);
}

// 1 m a step along the diagonal, through the border or past its end.
TEST(UnseenMeeting, ADiscCrossesABorderWhereItsWayDoes) {
  const auto ending = [](Vec2 place, Vec2 velocity) {
    Scene scene = soft_scene();
    scene.disc = {disc(place, 0.01, velocity)};
    Lattice l = lattice({0, 0}, 1, 2, 0.1);
    l.structural = {1e3, 1};
    scene.lattice = {l};
    return watched(scene, "verlet", 1e-3, 0.003).end.ending;
  };
  EXPECT_EQ(ending({-1.45, -1.5}, {1000, 1000}), Ending::diverged) << "at half of it";
  EXPECT_EQ(ending({-1.05, -0.15}, {550, 100}), Ending::finished) << "0.1 m behind its end";
}

TEST(UnseenMeeting, ALatticeCrossesAnotherOneOnASlantToo) {
  const auto worst = [](Vec2 place, Vec2 velocity) {
    Scene scene = soft_scene();
    Lattice stands = lattice({0, 0}, 1, 2, 0.1), comes = lattice(place, 1, 2, 0.005);
    for (Lattice* l : {&stands, &comes}) l->structural = {1e3, 1};
    comes.node = {node_setting(0, 0, {}, velocity), node_setting(0, 1, {}, velocity)};
    scene.lattice = {stands, comes};
    return watched(scene, "verlet", 1e-3, 0.003).of(WatchKind::crossing_lattices).worst;
  };
  EXPECT_EQ(worst({-1.45, -1.5}, {1000, 1000}), 2) << "each of its nodes";
  EXPECT_EQ(worst({-1.05, -0.15}, {550, 100}), 0);
}

// The right half of a lattice that is cut, 0.1 m a step through the left one.
TEST(UnseenMeeting, TheHalvesOfALatticeThatPassThroughEachOtherAreCounted) {
  Scene scene = soft_scene();
  Lattice l = lattice({0, 0}, 2, 6, 0.01);
  l.structural = l.shear = {1e3, 1};
  LinkSetting cut;
  cut.cut_from = Vec2{0.025, -0.01}, cut.cut_to = Vec2{0.025, 0.05}, cut.torn = true;
  l.link = {cut};
  for (int k = 0; k < 6; ++k) l.node.push_back(node_setting(k / 3, 3 + k % 3, {}, {-100, 0}));
  scene.lattice = {l};
  EXPECT_GT(watched(scene, "verlet", 1e-3, 0.003).of(WatchKind::crossing_lattices).worst, 0);
}

// What touches without being pressed, slides, or comes to a touch is no contact that a step was too long for.
TEST(UnseenMeeting, WhatOnlyTouchesMayMove) {
  for (const Vec2 velocity : {Vec2{11, 0}, Vec2{0, 11}}) {
    Scene scene = soft_scene();
    scene.wall = {wall({0, 0}, {0, 1})};
    scene.disc = {disc({0, 0.01}, 0.01, velocity)};
    EXPECT_EQ(watched(scene, "verlet", 1e-3, 0.003).end.ending, Ending::finished) << velocity.x;
  }
  Scene corner = soft_scene();
  corner.plate = {plate({0, -1}, 1, 1)};
  corner.disc = {disc({-0.0795, -0.0455}, 0.02, {25, 25})};
  EXPECT_EQ(watched(corner, "verlet", 1e-3, 0.01).end.ending, Ending::finished) << "1.2 R from the corner of a plate";
  Scene along = soft_scene();
  Lattice l = lattice({0, 0.005}, 1, 2, 0.001);
  l.structural = {1e3, 1};
  l.node = {node_setting(0, 0, {}, {3, 0}), node_setting(0, 1, {}, {3, 0})};
  along.lattice = {l};
  along.wall = {wall({0, 0}, {0, 1})};
  EXPECT_EQ(watched(along, "verlet", 1e-3, 0.01).end.ending, Ending::finished)
      << "5 mm above the wall: nodes are points";
}

// Pressed by 0.1 R, it leaves by 5 R in a step.
TEST(UnseenMeeting, AContactThatIsLeftInOneStepIsNotSeen) {
  Scene scene = soft_scene();
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.wall[0].name = "floor";
  scene.disc = {disc({0, 0.009}, 0.01, {0, 50})};
  const WatchedRun r = watched(allowing_all(scene), "verlet", 1e-3, 0.003);
  EXPECT_EQ(r.end.ending, Ending::diverged);
  EXPECT_EQ(r.end.reason.substr(0, 27), "disc 0 and wall floor touch") << r.end.reason;
  EXPECT_NE(r.end.reason.find("take a shorter step"), std::string::npos);
}

// As weak as they are, links that stretch by 4 spacings a step are broken ones.
TEST(UnseenMeeting, DrivenNodesDoNotOutrunTheirLinks) {
  Scene scene = soft_scene();
  Lattice l = lattice({0, 0}, 2, 2, 0.01);
  l.structural = l.shear = {1e-3, 0};
  l.drive = {{.rows = {0}, .velocity = {0, -40}}};
  scene.lattice = {l};
  EXPECT_EQ(watched(scene, "verlet", 1e-3, 0.01).end.ending, Ending::diverged);
}

// A node that is held strikes nothing, however light it is.
TEST(UnseenMeeting, HeldNodesAreNotWarnedOfImpacts) {
  std::vector<double> worst;
  for (const double mass : {1.0, 1e-9}) {
    Scene scene = empty_scene();
    scene.disc = {disc({0, 1}, 0.01, {0, -0.1})};
    Lattice l = lattice({0, 0}, 2, 2, 0.1);
    l.node_mass = mass;
    l.fixed_rows = {0, 1};
    scene.lattice = {l};
    worst.push_back(watched(scene, "verlet", 1e-4, 1e-3).of(WatchKind::arrival).worst);
  }
  EXPECT_EQ(worst[0], worst[1]);
}

}  // namespace
}  // namespace furrow::test
