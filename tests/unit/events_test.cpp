// Event location: the order that events cost, and that it comes back; its bounds; nothing changes without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

struct Went {
  State y;  // positions and velocities
  RunEnd end;
  long evaluations = 0;
  std::vector<Tear> torn;
};

Went go(const Scene& scene, const std::string& name, double step, bool events) {
  System system(scene);
  Went w{system.initial_state(), {}, 0, {}};
  const auto method = make_method(name);
  RunPlan plan;
  plan.end = scene.time.end;
  plan.step = step;
  plan.locate = events ? Locate::all : Locate::none;
  w.end = run(system, *method, w.y, plan, [&](double, const State&, const JumpReport& report) {
    w.torn.insert(w.torn.end(), report.torn.begin(), report.torn.end());
    return true;
  });
  w.evaluations = method->evaluations() + w.end.event_evaluations;
  w.y.resize(2 * system.positions());
  return w;
}

double distance(const State& a, const State& b) {
  double greatest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, std::fabs(a[i] - b[i]));
  return greatest;
}

// Slope of the root mean square error over 32 jittered steps each around end/coarse and end/(8 coarse): with equal
// steps the remainder before the event would be the same for all.
double order(const Scene& scene, const std::string& name, bool events, double coarse, const State& want) {
  std::mt19937_64 random(5);
  const auto error = [&](double steps) {
    double sum = 0;
    for (int k = 0; k < 32; ++k) {
      const double jitter = 1 + 0.5 * static_cast<double>(random() >> 11) * 0x1p-53;
      const double e = distance(go(scene, name, scene.time.end / (steps * jitter), events).y, want);
      sum += e * e;
    }
    return std::sqrt(sum / 32);
  };
  return std::log2(error(coarse) / error(8 * coarse)) / 3;
}

// A mass of 2 kg leaves at 2 m/s a spring of 400 N/m that tears at 30 N, at x = 75 mm, w t = asin(x w/v) with
// w^2 = 200/s^2, and flies on with sqrt(v^2 - w^2 x^2).
Scene tearing() {
  Scene scene = single_spring(400, 0, 30);
  scene.output.energy = false;
  scene.lattice[0].node = {node_setting(0, 1, {0, 0}, {2, 0})};
  scene.time.end = 0.15;
  return scene;
}
constexpr double tear_at = 0.075;
double tear_time() { return std::asin(tear_at * std::sqrt(200.0) / 2) / std::sqrt(200.0); }
State after_tear() {
  const double speed = std::sqrt(4 - 200 * tear_at * tear_at);
  return {1 + tear_at + speed * (0.15 - tear_time()), 0, speed, 0};
}

TEST(Events, ATearKeepsTheFullOrder) {
  EXPECT_NEAR(order(tearing(), "pece", false, 40, after_tear()), 1, 0.3);
  EXPECT_NEAR(order(tearing(), "pece", true, 100, after_tear()), 2, 0.25);
  EXPECT_NEAR(order(tearing(), "rk4", false, 10, after_tear()), 1, 0.3);
  EXPECT_NEAR(order(tearing(), "rk4", true, 16, after_tear()), 4, 0.5);
  EXPECT_GT(order(tearing(), "odeint_abm4", true, 20, after_tear()), 3.7);
}

TEST(Events, ATearIsReportedWhenItHappens) {
  const Went w = go(tearing(), "rk4", 1e-3, true);
  ASSERT_EQ(w.torn.size(), 1u);
  EXPECT_EQ(w.end.events, 1);
  EXPECT_EQ(w.end.steps, 150);  // those of the grid
  // The step lands 1e-9 of its length after the event; rk4's own error in x is some (h w)^5/120 of x a step.
  EXPECT_NEAR(w.torn[0].time, tear_time(), 2e-9);
  EXPECT_GT(w.torn[0].time, tear_time() - 1e-9);
}

// The step that is cut, and two evaluations for the cubic.
TEST(Events, CostOfATear) {
  const Went plain = go(tearing(), "pece", 1e-3, false);
  const Went located = go(tearing(), "pece", 1e-3, true);
  EXPECT_EQ(located.evaluations - plain.evaluations, 2 + 2);
}

// A disc against a wall, met at 13.7 ms, seen inside the contact. The reference is rk4 with graded steps, which this
// test finds to be of order 4, at 50 times the finest steps: its error is 1e-6 of theirs, and round-off.
Scene impact(double beta, double end) {
  Scene scene = empty_scene();
  scene.output.energy = false;
  scene.contact.damping_factor = beta;
  scene.disc = {disc({0, 0.1137}, 0.1, {0, -1})};
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.time.end = end;
  return scene;
}
State reference(const Scene& scene) { return go(scene, "rk4", scene.time.end / 5000.37, true).y; }

TEST(Events, DampedHertzKeepsTheFullOrder) {
  const Scene scene = impact(0.3, 0.0257);
  const State want = reference(scene);
  EXPECT_NEAR(order(scene, "pece", false, 40, want), 1.25, 0.3);
  EXPECT_NEAR(order(scene, "pece", true, 40, want), 2, 0.2);
  EXPECT_NEAR(order(scene, "rk4", false, 12, want), 1.25, 0.3);
  EXPECT_NEAR(order(scene, "rk4", true, 12, want), 4, 0.4);
}

TEST(Events, OverdampedHertzKeepsTheFullOrder) {
  const Scene scene = impact(3, 0.0257);
  const State want = reference(scene);
  EXPECT_NEAR(order(scene, "pece", true, 40, want), 2, 0.25);
  EXPECT_NEAR(order(scene, "rk4", true, 12, want), 4, 0.4);
}

TEST(Events, ElasticHertzKeepsTheFullOrder) {
  const Scene scene = impact(0, 0.08);
  const State want = reference(scene);
  EXPECT_NEAR(order(scene, "rk4", false, 40, want), 2.5, 0.4);
  EXPECT_NEAR(order(scene, "rk4", true, 40, want), 4, 0.4);
}

// Through the whole impact of a damped contact, which lets go while it is still closed: the normal force is held at
// zero.
TEST(Events, DampedImpactThatLetsGoKeepsTheFullOrder) {
  const Scene scene = impact(0.3, 0.4);
  const State want = reference(scene);
  EXPECT_EQ(go(scene, "rk4", 1e-3, true).end.events, 2);
  EXPECT_NEAR(order(scene, "pece", true, 100, want), 2, 0.25);
}

// Slides, then sticks.
TEST(Events, SlipThatStopsKeepsOrderTwo) {
  Scene scene = impact(0.2, 0.08);
  scene.contact.friction = 0.3;
  scene.model.gravity = 9.81;
  scene.disc[0].velocity = {0.25, -1};
  scene.disc[0].spin = 3;
  const State want = reference(scene);
  EXPECT_GE(go(scene, "rk4", 1e-3, true).end.events, 2);
  EXPECT_NEAR(order(scene, "pece", true, 60, want), 2, 0.25);
}

TEST(Events, WithoutAnyNothingChanges) {
  const Scene scene = single_spring(4, 0.1);
  for (const MethodInfo& info : method_catalogue()) {
    if (info.conservative) continue;
    Scene moving = scene;
    moving.lattice[0].node = {node_setting(0, 1, {0.1, 0})};
    moving.time.end = 1;
    const Went plain = go(moving, info.name, 0.125, false);
    const Went located = go(moving, info.name, 0.125, true);
    EXPECT_EQ(plain.y, located.y) << info.name;
    EXPECT_EQ(plain.evaluations, located.evaluations) << info.name;
  }
}

// A bed: events in every step.
TEST(Events, TooManyAreADivergenceThatSaysSo) {
  Scene scene = busy_scene(40);
  scene.time.end = 0.5;
  const Went w = go(scene, "pece", 1e-4, true);
  EXPECT_EQ(w.end.ending, Ending::diverged);
  EXPECT_NE(w.end.reason.find("scenes with few"), std::string::npos) << w.end.reason;
}

}  // namespace
}  // namespace furrow
