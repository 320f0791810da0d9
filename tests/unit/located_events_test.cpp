// Events inside a step: what counts as one, how many there are, and what is left when a run with them diverges.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

struct Located {
  Located(const Scene& scene, const std::string& name, double step, Locate what) : system(scene) {
    State y = system.initial_state();
    const auto method = make_method(name);
    end = run(system, *method, y, {.start = 0, .end = scene.time.end, .step = step, .locate = what},
              [&](double t, const State& now, const JumpReport& report) {
                torn.insert(torn.end(), report.torn.begin(), report.torn.end());
                last_time = t;
                last = now;
                return true;
              });
    state = y;
    evaluations = method->evaluations();
  }
  System system;
  RunEnd end;
  State state, last;  // after the run; as it was last reported
  double last_time = -1;
  std::vector<Tear> torn;
  long evaluations = 0;
};

// A mass of 2 kg is thrown against a spring of 400 N/m that breaks at 30 N, in either sense or pulled only. Where it
// breaks in compression, x = -v/w sin(w t) = -75 mm with w^2 = 200/s^2.
Scene pressed(TearRule rule) {
  Scene scene = single_spring(400, 0, 30);
  scene.lattice[0].tear = rule;
  scene.lattice[0].node = {node_setting(0, 1, {0, 0}, {-2, 0})};
  scene.time.end = 0.1;
  return scene;
}
double pressed_until() { return std::asin(0.075 * std::sqrt(200.0) / 2) / std::sqrt(200.0); }

TEST(LocatedEvents, ATearInCompressionIsFoundUnderTheMagnitudeRule) {
  for (const Locate what : {Locate::tears, Locate::all}) {
    const Located run(pressed(TearRule::magnitude), "rk4", 1e-2, what);
    ASSERT_EQ(run.torn.size(), 1u);
    EXPECT_NEAR(run.torn[0].time, pressed_until(), 1e-5);  // a cubic over a step of w h = 0.14: (w h)^4/384 of it
    EXPECT_NEAR(run.torn[0].force, -30, 1e-3);
    EXPECT_EQ(run.end.events, 1);
    EXPECT_EQ(run.end.event_evaluations, 2);
    EXPECT_EQ(run.end.steps, 10);
  }
}

TEST(LocatedEvents, CompressionTearsNothingUnderTheTensionRule) {
  const Located run(pressed(TearRule::tension), "rk4", 1e-2, Locate::all);
  EXPECT_TRUE(run.torn.empty());
  EXPECT_EQ(run.end.events, 0);
  EXPECT_EQ(run.end.event_evaluations, 0);
}

TEST(LocatedEvents, TwoTearsInOneStepAreTwoEventsInTheirOrder) {
  Scene scene = empty_scene();
  for (const double strength : {10.0, 14.0}) {
    Lattice l = lattice({0, strength}, 1, 2, 1);
    l.fixed_columns = {0};
    l.structural = link_kind(400, 0, strength);
    l.node = {node_setting(0, 1, {}, {2, 0})};
    scene.lattice.push_back(l);
  }
  scene.time.end = 0.05;
  const Located run(scene, "rk4", 0.025, Locate::tears);
  ASSERT_EQ(run.torn.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const double w = std::sqrt(200.0), stretch = (k == 0 ? 10.0 : 14.0) / 400;
    EXPECT_EQ(run.torn[k].link, static_cast<int>(k));
    EXPECT_NEAR(run.torn[k].time, std::asin(stretch * w / 2) / w, 1e-4);
  }
  EXPECT_EQ(run.end.events, 2);
  EXPECT_EQ(run.end.event_evaluations, 4);
  EXPECT_EQ(run.end.steps, 2);
}

// A disc is thrown up a slope so slick that its slip reverses: g (sin + 3 mu cos) brakes it, g (sin - 3 mu cos) drives
// it back. Between the two its spring unwinds from one end of its reach to the other, in 3 ms, less than a step.
class Reversal : public testing::Test {
 protected:
  static constexpr double slope = 0.5, mu = 1e-3, radius = 0.1;  // rad, -, m
  static constexpr double throw_at = 0.2;                        // m/s

  static Scene scene() {
    Scene s = empty_scene();
    s.model.gravity = 9.81;
    s.contact.friction = mu;
    s.output.energy = false;
    const double normal = 1000 * 3.14159265358979323846 * radius * radius * 9.81 * std::cos(slope);
    const double overlap = std::pow(normal / (4.0 / 3 * 1e6 / 1.875 * std::sqrt(radius)), 2.0 / 3);  // at rest
    s.wall = {wall({0, 0}, {-std::sin(slope), std::cos(slope)})};
    s.disc = {disc({-std::sin(slope) * (radius - overlap), std::cos(slope) * (radius - overlap)}, radius,
                   {throw_at * std::cos(slope), throw_at * std::sin(slope)})};
    s.time.end = 0.1;
    return s;
  }
  static double turned() { return throw_at / (9.81 * (std::sin(slope) + 3 * mu * std::cos(slope))); }
};

TEST_F(Reversal, OfASlideWithinAStepIsSeen) {
  const Located run(scene(), "rk4", 5e-3, Locate::all);
  EXPECT_EQ(run.end.ending, Ending::finished) << run.end.reason;
  EXPECT_EQ(run.end.events, 3);  // its spring is wound up; it stops to slide up, it begins to slide down
  const double along =
      run.state[run.system.vx_of(0)] * std::cos(slope) + run.state[run.system.vy_of(0)] * std::sin(slope);
  const double up = 9.81 * (std::sin(slope) + mu * std::cos(slope)),
               down = 9.81 * (std::sin(slope) - mu * std::cos(slope));
  const double want = throw_at - up * turned() - down * (0.1 - turned());
  EXPECT_NEAR(along, want, 2 * mu * 9.81 * 3e-3);  // what friction could do while it neither slides up nor down
  const double spin = -2 * mu * 9.81 * std::cos(slope) / radius * (turned() - (0.1 - turned()));
  EXPECT_NEAR(std::fabs(run.state[run.system.spin_of(0)]), std::fabs(spin), 4 * mu * 9.81 / radius * 3e-3);
}

TEST_F(Reversal, IsNoEventForOneWhoAsksForTears) {
  EXPECT_EQ(Located(scene(), "rk4", 5e-3, Locate::tears).end.events, 0);
}

// It falls at 1 m/s, touches, is held at zero force when it opens (damped), and lets go.
TEST(LocatedEvents, ADampedBounceIsATouchARelease) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.3;
  scene.disc = {disc({0, 0.11}, 0.1, {0, -1})};
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.time.end = 0.3;
  const Located run(scene, "rk4", 1e-3, Locate::all);
  EXPECT_EQ(run.end.events, 2);
  EXPECT_GT(run.state[run.system.vy_of(0)], 0.3);
  EXPECT_GT(run.end.event_evaluations, 2);
}

// After a divergence the state is that after the last whole step, whatever was located in the one that failed.
TEST(LocatedEvents, ADivergedStepLeavesTheStateBeforeIt) {
  Scene scene = pressed(TearRule::magnitude);
  scene.disc = {disc({5, 0}, 0.004, {0, 0.5})};
  scene.model.gravity = 0;
  scene.time.end = 0.2;
  // A second mass that its spring throws further in a step than its spacing, after the first has torn.
  Lattice l = lattice({0, 3}, 1, 2, 0.01);
  l.fixed_columns = {0};
  l.node_mass = 1e-6;
  l.structural = link_kind(1, 0);
  l.node = {node_setting(0, 1, {1e-6, 0})};
  scene.lattice.push_back(l);
  for (const Locate what : {Locate::none, Locate::tears, Locate::all}) {
    const Located run(scene, "rk4", 4e-3, what);
    ASSERT_EQ(run.end.ending, Ending::diverged);
    EXPECT_NE(run.end.reason.find("node (row 0, column 1)"), std::string::npos) << run.end.reason;
    EXPECT_EQ(run.end.time, run.last_time);
    EXPECT_NEAR(run.end.time, static_cast<double>(run.end.steps) * 4e-3, 1e-15);
    EXPECT_EQ(run.state, run.last);
  }
}

// A disc that touches a wall by rounding, without a force: regimes change with the last bit, events there are none.
TEST(LocatedEvents, WhatOnlyRoundingChangesIsNoEvent) {
  Scene scene = empty_scene();
  scene.model.gravity = 0;
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.disc = {disc({0.1, 0.01}, 0.01)};
  scene.time.end = 0.01;
  for (const MethodInfo& info : method_catalogue()) {
    const Located run(scene, info.name, 1e-4, Locate::all);
    EXPECT_EQ(run.end.ending, Ending::finished) << info.name << ": " << run.end.reason;
  }
}

}  // namespace
}  // namespace furrow
