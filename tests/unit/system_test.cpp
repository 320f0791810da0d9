// A scene made ready: what its state holds, its loads, and that the right-hand side leaves no trace.
#include "run/system.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

std::size_t size_of(Scene scene, bool energy) {
  scene.output.energy = energy;
  return System(scene).size();
}

TEST(StateLayout, OfASpringIsItsFreeNode) {
  EXPECT_EQ(size_of(single_spring(1, 0), false), 4u);
  EXPECT_EQ(size_of(single_spring(1, 0), true), 4u + ledger_entries);
}

TEST(StateLayout, OfASpringInARoughWorldIsTheSame) {
  Scene scene = single_spring(1, 0);
  scene.contact.friction = 0.5;
  scene.contact.rolling_friction = 0.5;
  EXPECT_EQ(size_of(scene, false), 4u);
}

TEST(StateLayout, WithoutFrictionHasNoSpinsAndNoSprings) {
  Scene scene = busy_scene(5);
  scene.contact.friction = scene.contact.rolling_friction = 0;
  EXPECT_EQ(size_of(scene, false), 4u * (5 + 15));  // 6 x 3 nodes, one row fixed
}

TEST(StateLayout, WithFrictionHasASpinADiscAndSpringsForItsContacts) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.disc = {disc({0, 0}, 0.1), disc({1, 0}, 0.1), disc({2, 0}, 0.1)};
  scene.wall = {wall({0, -1}, {0, 1})};
  // Three pairs and three times the wall are all there can be, and one place for what holds no spring.
  EXPECT_EQ(size_of(scene, false), 4u * 3 + 3 + (3 + 3) + 1);
}

TEST(StateLayout, SpringsGrowInProportionToTheDiscs) { EXPECT_LE(System(busy_scene(400)).spring_count(), 10 * 400); }

TEST(StateLayout, FrictionOfOnePairOfMaterialsIsEnough) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1), disc({1, 0}, 0.1)};
  ContactPair pair;
  pair.materials = {"soft", "soft"};
  pair.friction = 0.5;
  scene.contact.pair = {pair};
  EXPECT_EQ(size_of(scene, false), 4u * 2 + 2 + 1 + 1);
}

TEST(InitialState, IsWhatTheSceneSays) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.disc = {disc({1, 2}, 0.1, {3, 4}, 5)};
  Lattice l = lattice({10, 20}, 1, 2, 1);
  l.fixed_columns = {0};
  l.node = {node_setting(0, 1, {0.25, 0.5}, {6, 7})};
  scene.lattice = {l};
  const System system(scene);
  const State y = system.initial_state();
  EXPECT_EQ(State(y.begin(), y.begin() + 9), (State{1, 11.25, 2, 20.5, 3, 6, 4, 7, 5}));
  EXPECT_TRUE(std::all_of(y.begin() + 9, y.end(), [](double v) { return v == 0; }));
}

TEST(Gravity, AcceleratesADiscByExactlyG) {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.disc = {disc({0, 0}, 0.1, {3, 4}), disc({1, 0}, 0.07)};
  const System system(scene);
  const State dydt = rates(system, 0, system.initial_state());
  for (const int body : {0, 1}) {
    EXPECT_EQ(dydt[system.vx_of(body)], 0);
    EXPECT_EQ(dydt[system.vy_of(body)], -9.81);
  }
  EXPECT_EQ(dydt[system.x_of(0)], 3);
  EXPECT_EQ(dydt[system.y_of(0)], 4);
}

TEST(Gravity, ActsOnALatticeOnlyIfAsked) {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.lattice = {lattice({0, 0}, 1, 1, 1), lattice({5, 0}, 1, 1, 1)};
  scene.lattice[1].gravity = true;
  const System system(scene);
  const State dydt = rates(system, 0, system.initial_state());
  EXPECT_EQ(dydt[system.vy_of(0)], 0);
  EXPECT_EQ(dydt[system.vy_of(1)], -9.81);
}

TEST(Load, AcceleratesItsNode) {
  Scene scene = empty_scene();
  scene.lattice = {lattice({0, 0}, 1, 1, 1)};  // 2 kg
  scene.lattice[0].node = {node_setting(0, 0, {}, {}, {3, -5})};
  const System system(scene);
  const State dydt = rates(system, 0, system.initial_state());
  EXPECT_EQ(dydt[system.vx_of(0)], 1.5);
  EXPECT_EQ(dydt[system.vy_of(0)], -2.5);
}

TEST(FixedNodes, HaveNoPlaceInTheStateAndDoNotMove) {
  Scene scene = single_spring(100, 0);
  scene.lattice[0].node = {node_setting(0, 0, {}, {7, 7}), node_setting(0, 1, {0.5, 0})};
  System system(scene);
  State y = system.initial_state();
  const auto method = make_method("rk4");
  for (int k = 0; k < 100; ++k) method->step(system, k * 0.01, y, 0.01);
  const NodeMotion nodes = system.nodes(0, y);
  EXPECT_EQ(nodes.x[0], 0);
  EXPECT_EQ(nodes.y[0], 0);
  EXPECT_EQ(nodes.vx[0], 0);
  EXPECT_NE(nodes.x[1], 1.5);
}

// The same (t, y) gives the same bits, whatever was asked before.
TEST(RightHandSide, LeavesNoTrace) {
  System system(busy_scene());
  State y = system.initial_state();
  const auto method = make_method("pece");
  RunPlan plan;
  plan.end = 0.02;
  ASSERT_EQ(run(system, *method, y, plan, [](double, const State&, const JumpReport&) { return true; }).ending,
            Ending::finished);
  const State here = rates(system, 0.02, y);
  EXPECT_EQ(rates(system, 0.02, y), here);
  State elsewhere = y;
  for (int body = 0; body < system.parts().bodies(); ++body) elsewhere[system.x_of(body)] *= 1.3;
  const State there = rates(system, 0.03, elsewhere);
  rates(system, -4, system.initial_state());
  EXPECT_EQ(rates(system, 0.02, y), here);
  EXPECT_EQ(rates(system, 0.03, elsewhere), there);
  EXPECT_NE(here, there);
}

}  // namespace
}  // namespace furrow
