// Between steps: which links tear and what that leaves, in the flow, the ledger and the hash.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// k = 4 N/m pulled (or pushed) by exactly 1/2 m: 2 N.
Scene stretched_by(double stretch, TearRule rule = TearRule::tension) {
  Scene scene = single_spring(4, 1, 2);
  scene.lattice[0].tear = rule;
  scene.lattice[0].node = {node_setting(0, 1, {stretch, 0}, {0.25, 0})};
  return scene;
}

JumpReport jump_of(const Scene& scene) {
  System system(scene);
  State y = system.initial_state();
  return system.jump(0, y);
}

TEST(Tear, HappensAboveTheStrengthAndNotAtIt) {
  EXPECT_TRUE(jump_of(stretched_by(0.5)).torn.empty());
  const JumpReport report = jump_of(stretched_by(0.5 + 1e-15));
  ASSERT_EQ(report.torn.size(), 1u);
  EXPECT_EQ(report.torn[0].link, 0);
  EXPECT_NEAR(report.torn[0].force, 2, 1e-14);
  EXPECT_TRUE(report.flow_jumped());
}

TEST(Tear, InCompressionOnlyByMagnitude) {
  EXPECT_TRUE(jump_of(stretched_by(-0.9)).torn.empty());
  EXPECT_TRUE(jump_of(stretched_by(-0.5, TearRule::magnitude)).torn.empty());
  EXPECT_EQ(jump_of(stretched_by(-0.51, TearRule::magnitude)).torn.size(), 1u);
  EXPECT_EQ(jump_of(stretched_by(0.51, TearRule::magnitude)).torn.size(), 1u);
}

TEST(Tear, DependsOnTheSpringNotOnTheDamper) {
  Scene scene = stretched_by(0.49);
  scene.lattice[0].structural.damping = 1e6;
  EXPECT_TRUE(jump_of(scene).torn.empty());
}

TEST(Tear, EndsSpringAndDamperForGood) {
  System system(stretched_by(0.75));
  State y = system.initial_state();
  EXPECT_EQ(rates(system, 0, y)[system.vx_of(0)], (-4 * 0.75 - 1 * 0.25) / 2);  // 2 kg
  EXPECT_EQ(system.jump(3, y).torn.at(0).time, 3);
  EXPECT_TRUE(system.torn(0));
  EXPECT_EQ(rates(system, 0, y)[system.vx_of(0)], 0);
  y[system.x_of(0)] = 1;  // back at rest length
  EXPECT_TRUE(system.jump(4, y).torn.empty());
  EXPECT_TRUE(system.torn(0));
  y[system.x_of(0)] = 0.5;
  EXPECT_EQ(rates(system, 0, y)[system.vx_of(0)], 0);
}

TEST(Tear, EnergyOfTheSpringIsBooked) {
  System system(stretched_by(0.75));
  State y = system.initial_state();
  system.jump(0, y);
  EXPECT_EQ(y[system.ledger_of(tear_energy)], 0.5 * 4 * 0.75 * 0.75);
}

TEST(Tear, OfEqualLinksHappensAtOnce) {
  Scene scene = stretched_by(0.75);
  scene.lattice.push_back(scene.lattice[0]);
  scene.lattice[1].origin.y = 5;
  const JumpReport report = jump_of(scene);
  ASSERT_EQ(report.torn.size(), 2u);
  EXPECT_EQ(report.torn[0].link, 0);
  EXPECT_EQ(report.torn[1].link, 1);
}

TEST(Tear, DoesNotHappenWhileTheSceneIsPrepared) {
  System system(stretched_by(0.75));
  State y = system.initial_state();
  system.prepare(true);
  EXPECT_TRUE(system.jump(0, y).torn.empty());
  system.prepare(false);
  EXPECT_EQ(system.jump(0, y).torn.size(), 1u);
}

// A disc over the middle of a segment, and one over its end: the link tears, the node stays.
TEST(Tear, LeavesOnlyTheNodesOfABorderSegment) {
  System system(on_a_segment_that_tears({disc({0.6, 0.09}, 0.1), disc({0, 0.09}, 0.1)}));
  State y = system.initial_state();
  const State before = rates(system, 0, y);
  EXPECT_GT(before[system.vy_of(0)], 0);
  EXPECT_GT(before[system.vy_of(1)], 0);
  ASSERT_EQ(system.jump(0, y).torn.size(), 1u);
  const State after = rates(system, 0, y);
  EXPECT_EQ(after[system.vy_of(0)], 0);
  EXPECT_EQ(after[system.vy_of(1)], before[system.vy_of(1)]);
}

TEST(StateHash, KnowsTornLinksAndEveryBit) {
  System system(stretched_by(0.75));
  State y = system.initial_state();
  const std::uint64_t whole = system.state_hash(y);
  State nudged = y;
  nudged[0] = std::nextafter(nudged[0], 9);
  EXPECT_NE(system.state_hash(nudged), whole);
  State ledger = y;
  ledger.back() = 1;  // not part of the motion
  EXPECT_EQ(system.state_hash(ledger), whole);
  system.jump(0, y);
  EXPECT_NE(system.state_hash(y), whole);
}

}  // namespace
}  // namespace furrow
