// A force of the caller's own acts like any other: in the flow, in what a jump hands over, in copies, in messages.
#include <gtest/gtest.h>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// Linear drag on every disc, in units of its mass: a = -rate v.
OwnForce drag(double rate) {
  return {[rate](const System& system, double, const State& y, State& rates) {
            for (int i = 0; i < system.parts().disc.count(); ++i) {
              rates[system.vx_of(i)] -= rate * y[system.vx_of(i)];
              rates[system.vy_of(i)] -= rate * y[system.vy_of(i)];
            }
          },
          "drag"};
}

TEST(OwnForce, ASystemAddsItToTheAccelerationsAndToNothingElse) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1, {3, -2})};
  System plain(scene), dragged(scene);
  dragged.add_force(drag(0.5));
  const State y = plain.initial_state();
  State without(y.size()), with(y.size());
  plain.rhs(0, y, without);
  dragged.rhs(0, y, with);
  without[plain.vx_of(0)] -= 0.5 * 3;
  without[plain.vy_of(0)] += 0.5 * 2;
  EXPECT_EQ(with, without);
  System copy(dragged);
  copy.rhs(0, y, with);
  EXPECT_EQ(with, without);
}

// With friction a jump knows the rates of the next step's start. Without the force they would be others.
TEST(OwnForce, TheRatesThatAJumpHandsOverHaveIt) {
  System system(busy_scene());
  ASSERT_TRUE(system.has_friction());
  system.add_force(drag(0.5));
  State y = system.initial_state();
  const JumpReport report = system.jump(0, y);
  ASSERT_NE(report.rates, nullptr);
  State rates(y.size());
  system.rhs(0, y, rates);
  EXPECT_EQ(*report.rates, rates);
}

// v = v0 exp(-t rate), x = v0 (1 - exp(-t rate)) / rate.
TEST(OwnForce, DragSlowsADiscExponentially) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1, {3, 0})};
  System system(scene);
  system.add_force(drag(2));
  State y = system.initial_state();
  const auto method = make_method("rk4");
  run(system, *method, y, {.start = 0, .end = 1, .step = 1e-2, .stop = {}},
      [](double, const State&, const JumpReport&) { return true; });
  // rk4: the error of a step is (rate h)^5 / 120 = 3e-11 of the speed, at most a hundred times that after 100 steps.
  EXPECT_NEAR(y[system.vx_of(0)], 3 * std::exp(-2.0), 1e-8);
  EXPECT_NEAR(y[system.x_of(0)], 3 * (1 - std::exp(-2.0)) / 2, 1e-8);
}

TEST(OwnForce, OneThatDependsOnVelocityIsRefusedByAConservativeMethod) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1)};
  System system(scene);
  const auto conservative = [] {
    for (const MethodInfo& m : method_catalogue())
      if (m.conservative) return m;
    return MethodInfo{};
  }();
  ASSERT_TRUE(conservative.conservative);
  EXPECT_EQ(refusal(conservative, system), "");
  system.add_force(drag(1));
  EXPECT_NE(refusal(conservative, system).find("drag"), std::string::npos) << refusal(conservative, system);
}

}  // namespace
}  // namespace furrow
