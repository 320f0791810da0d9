// Tears located within a step: a mass flies off on a spring that tears at a known moment.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

constexpr double stiffness = 8, mass = 2, speed = 3, strength = 10;  // N/m, kg, m/s, N
const double omega = std::sqrt(stiffness / mass);
const double tear_time = std::asin(strength * omega / (stiffness * speed)) / omega;  // k x = strength, x = v/w sin w t
const double speed_after = speed * std::cos(omega * tear_time);

Scene flying_off() {
  Scene scene = single_spring(stiffness, 0, strength);
  scene.lattice[0].node = {node_setting(0, 1, {0, 0}, {speed, 0})};
  return scene;
}

struct Flight {
  std::vector<double> times;
  std::vector<Tear> torn;
  RunEnd end;
  double speed = 0;
  std::uint64_t hash = 0;
  long evaluations = 0;
};

Flight fly(const Scene& scene, const std::string& name, double step, Locate locate) {
  System system(scene);
  State y = system.initial_state();
  const auto method = make_method(name, {.relative = 1e-9, .absolute = 1e-9, .first_step = 1e-3});
  Flight f;
  f.end = run(system, *method, y, {.start = 0, .end = 2, .step = step, .stop = {}, .locate = locate},
              [&](double t, const State&, const JumpReport& report) {
                f.times.push_back(t);
                f.torn.insert(f.torn.end(), report.torn.begin(), report.torn.end());
                return true;
              });
  f.speed = y[system.vx_of(0)];
  f.hash = system.state_hash(y);
  f.evaluations = method->evaluations();
  return f;
}

double located_error(const std::string& name, double step) {
  const Flight f = fly(flying_off(), name, step, Locate::tears);
  EXPECT_EQ(f.torn.size(), 1U);
  return std::fabs(f.torn.at(0).time - tear_time) + std::fabs(f.speed - speed_after);
}

// Steps whose ends stand differently towards the tear would scatter the slope: none of these ends near it.
TEST(LocatedTear, KeepsTheOrderOfTheMethod) {
  EXPECT_NEAR(std::log2(located_error("rk4", 0.08) / located_error("rk4", 0.02)) / 2, 4, 0.6);
  EXPECT_NEAR(std::log2(located_error("pece", 0.002) / located_error("pece", 0.0005)) / 2, 2,
              0.1);  // the next term is 2.5 omega h of it
  EXPECT_LT(located_error("rk4", 0.01), 1e-8);
}

TEST(LocatedTear, OtherwiseIsSeenAtTheEndOfTheStep) {
  const double step = 0.08;
  const Flight late = fly(flying_off(), "rk4", step, Locate::none);
  EXPECT_EQ(late.torn.at(0).time, step * std::ceil(tear_time / step));
  EXPECT_GT(std::fabs(late.speed - speed_after), 0.01);
}

// A trial step and the rest of the step where one was before, two evaluations for the cubic.
TEST(LocatedTear, IsFollowedByTheRestOfItsStep) {
  const Flight f = fly(flying_off(), "pece", 0.08, Locate::tears);
  EXPECT_EQ(f.end.events, 1);
  EXPECT_EQ(f.end.event_evaluations, 2);
  EXPECT_EQ(f.end.steps, 25);  // those of the grid
  EXPECT_EQ(f.evaluations, 2 * (25 + 1));
  for (const double t : f.times) EXPECT_EQ(t, 0.08 * std::round(t / 0.08));
  EXPECT_EQ(f.times.back(), 2);
}

TEST(LocatedTear, EveryMethodFindsIt) {
  for (const MethodInfo& info : method_catalogue()) {
    const Flight f = fly(flying_off(), info.name, info.order == 1 ? 1e-4 : 1e-3, Locate::tears);
    ASSERT_EQ(f.torn.size(), 1U) << info.name;
    EXPECT_NEAR(f.torn[0].time, tear_time, 1e-3) << info.name;  // of first order: 1e-4 times a few
    EXPECT_NEAR(f.speed, speed_after, 2e-3) << info.name;
  }
}

TEST(LocatedTear, ChangesNoBitWhereNothingTears) {
  Scene scene = flying_off();
  scene.lattice[0].structural.strength = infinity;
  for (const MethodInfo& info : method_catalogue()) {
    EXPECT_EQ(fly(scene, info.name, 0.01, Locate::tears).hash, fly(scene, info.name, 0.01, Locate::none).hash)
        << info.name;
  }
}

}  // namespace
}  // namespace furrow
