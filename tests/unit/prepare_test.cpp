// From a scene as written to t = 0: packings placed, discs settled, plates at their depth.
#include "run/prepare.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "run/observe.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// Twenty discs in a box 0.1 m wide, damped enough to come to rest within half a second.
Scene box() {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.contact.damping_factor = 0.5;
  scene.contact.friction = 0.5;
  scene.contact.rolling_friction = 0.1;
  scene.wall = {wall({0, 0}, {0, 1}), wall({-0.05, 0}, {1, 0}), wall({0.05, 0}, {-1, 0})};
  Packing p;
  p.count = 20;
  p.radius_min = 0.006;
  p.radius_max = 0.01;
  p.lower_left = {-0.05, 0};
  p.upper_right = {0.05, 0.15};
  p.material = "soft";
  scene.packing = {p};
  Settle settle;
  settle.speed = 5e-3;
  settle.hold = 0.1;
  settle.limit = 5;
  scene.settle = settle;
  return scene;
}

Scene box_with_plate(double depth) {
  Scene scene = box();
  Plate p = plate({-0.04, 0}, 0.005, 0.1, {0.1, 0});
  p.lower_edge.reset();
  p.working_depth = depth;
  scene.plate = {p};
  return scene;
}

TEST(Prepare, WithoutSettlingIsTheSceneAsWritten) {
  Scene scene = box();
  scene.settle.reset();
  const Prepared p = prepare(scene);
  EXPECT_EQ(p.scene.disc.size(), 20u);
  EXPECT_EQ(p.y, p.system.initial_state());
  EXPECT_FALSE(p.surface.has_value());
  EXPECT_EQ(p.settling_time, 0);
}

TEST(Prepare, SettledDiscsAreSlowAndLieInTheBox) {
  const Prepared p = prepare(box());
  EXPECT_LE(greatest_speed(p.system, p.y), 5e-3);
  EXPECT_GT(p.settling_time, 0.1);
  EXPECT_EQ(p.settling_steps, std::lround(p.settling_time / 1e-4));
  const Observation seen = observe(p.system, 0, p.y);
  EXPECT_GT(seen.contacts, 20);
  double weight = 0;
  for (int i = 0; i < 20; ++i) {
    weight += 9.81 * p.system.parts().disc.mass[i];
    EXPECT_GT(p.y[p.system.y_of(i)], 0);
    EXPECT_LT(p.y[p.system.y_of(i)], 0.08);  // a bed of loosely packed discs is 0.05 m high at most
  }
  // At rest, the floor and the walls carry the weight: the forces on all discs add up to little.
  const State dydt = rates(p.system, 0, p.y);
  double rest = 0;
  for (int i = 0; i < 20; ++i) rest += force_on(p.system, dydt, i).y;
  EXPECT_LT(std::fabs(rest), 0.05 * weight);
}

TEST(Prepare, LedgerIsZeroAtTheStart) {
  const Prepared p = prepare(box());
  ASSERT_TRUE(p.system.keeps_ledger());
  for (int k = 0; k < ledger_entries; ++k) EXPECT_EQ(p.y[p.system.ledger_of(static_cast<Ledger>(k))], 0);
}

TEST(Prepare, PlateEndsAtItsDepthBelowTheSurfaceOfTheBedWithoutIt) {
  const Prepared bare = prepare(box());
  const Prepared p = prepare(box_with_plate(0.01));
  ASSERT_TRUE(bare.surface.has_value());
  ASSERT_TRUE(p.surface.has_value());
  EXPECT_EQ(*bare.surface, surface_height(bare.system, bare.y));
  EXPECT_EQ(*p.surface, *bare.surface);
  ASSERT_EQ(p.scene.plate.size(), 1u);
  EXPECT_EQ(*p.scene.plate[0].lower_edge, *bare.surface - 0.01);
  EXPECT_FALSE(p.scene.plate[0].working_depth.has_value());
  EXPECT_GT(p.settling_steps, bare.settling_steps);
}

TEST(Prepare, PlateRestsWhileTheBedSettlesAndMovesAfterwards) {
  Prepared p = prepare(box_with_plate(0.01));
  EXPECT_EQ(p.system.plate_at(0, 0).left, -0.04);
  EXPECT_EQ(p.system.plate_at(0, 0).vx, 0.1);
  EXPECT_EQ(p.system.plate_at(0, 0.5).left, -0.04 + 0.1 * 0.5);
  // It stood in the bed: no disc is deep inside it.
  const Observation seen = observe(p.system, 0, p.y);
  EXPECT_LT(seen.overlap.relative, 0.5);
}

TEST(Prepare, GivesTheSameBitsEveryTime) {
  const Prepared one = prepare(box_with_plate(0.01));
  const Prepared other = prepare(box_with_plate(0.01));
  EXPECT_EQ(one.system.state_hash(one.y), other.system.state_hash(other.y));
}

TEST(Prepare, LinksDoNotTearBeforeTheStart) {
  Scene scene = box();
  Lattice l = lattice({1, 0}, 1, 2, 1);
  l.structural = link_kind(10, 20, 1);  // stretched by 0.5 m: 5 N, five times its strength
  l.fixed_columns = {0, 1};
  l.node = {node_setting(0, 1, {0.5, 0})};
  scene.lattice = {l};
  Prepared p = prepare(scene);
  EXPECT_FALSE(p.system.torn(0));
  EXPECT_EQ(p.system.jump(0, p.y).torn.size(), 1u);
}

TEST(Prepare, SettlesByItsOwnStepIfThereIsOne) {
  Scene scene = box();
  scene.settle->step = 5e-5;
  const Prepared p = prepare(scene);
  EXPECT_EQ(p.settling_steps, std::lround(p.settling_time / 5e-5));
}

TEST(Prepare, ABedThatDoesNotSettleInTimeIsAnError) {
  Scene scene = box();
  scene.settle->limit = 0.05;
  try {
    prepare(scene);
    FAIL() << "nothing settles in 0.05 s";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("not settled after 0.05 s"), std::string::npos) << error.what();
  }
}

// One disc of 21 is on its way up for four seconds; the others are at rest after one.
TEST(Prepare, ADiscThatMovesKeepsABedFromSettlingUnlessItMayBeLoose) {
  Scene scene = box();
  scene.disc = {disc({0, 10}, 0.01, {0, 40})};
  scene.settle->limit = 2;
  EXPECT_THROW(prepare(scene), Divergence);
  scene.settle->loose = 0.04;
  EXPECT_THROW(prepare(scene), Divergence);
  scene.settle->loose = 0.05;
  const Prepared p = prepare(scene);
  EXPECT_GT(greatest_speed(p.system, p.y), 20);
  EXPECT_LE(greatest_speed(p.system, p.y, 0.05), 5e-3);
}

TEST(Prepare, ABedThatBlowsUpIsADivergence) {
  Scene scene = box();
  scene.time.step = 0.05;  // a disc falls past the floor
  EXPECT_THROW(prepare(scene), Divergence);
}

TEST(Prepare, ProgressIsToldAndMayInterrupt) {
  std::vector<double> times;
  prepare(box(), [&](double t, double speed) {
    times.push_back(t);
    EXPECT_GE(speed, 0);
    return true;
  });
  EXPECT_GT(times.size(), 5u);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  EXPECT_THROW(prepare(box(), [](double, double) { return false; }), Interrupted);
  EXPECT_THROW(prepare(box(), [](double t, double) { return t < 0.1; }), Interrupted);
}

}  // namespace
}  // namespace furrow
