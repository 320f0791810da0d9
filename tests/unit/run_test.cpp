// The loop around a method: when it steps, when it stops, and what is left when it fails.
#include "run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

struct Ran {
  RunEnd end;
  State y;                    // as the run left it
  std::vector<double> times;  // of the calls
  std::vector<State> states;
};

Ran run_through(const Scene& scene, Method& method, const RunPlan& plan) {
  System system(scene);
  Ran r;
  r.y = system.initial_state();
  r.end = run(system, method, r.y, plan, [&](double t, const State& now, const JumpReport&) {
    r.times.push_back(t);
    r.states.push_back(now);
    return true;
  });
  return r;
}

RunPlan plan_of(double end, double step, double start = 0) {
  RunPlan plan;
  plan.start = start;
  plan.end = end;
  plan.step = step;
  return plan;
}

TEST(Run, FixedStepsAreCountedNotSummed) {
  const auto method = make_method("verlet");
  const Ran r = run_through(single_spring(1, 0), *method, plan_of(100, 0.1));
  EXPECT_EQ(r.end.ending, Ending::finished);
  EXPECT_EQ(r.end.steps, 1000);
  ASSERT_EQ(r.times.size(), 1001u);
  for (int n = 0; n < 1000; ++n) ASSERT_EQ(r.times[n], n * 0.1);
  EXPECT_EQ(r.times.back(), 100);
  EXPECT_EQ(r.end.time, 100);
}

TEST(Run, CountsFromItsStart) {
  const auto method = make_method("verlet");
  const Ran r = run_through(single_spring(1, 0), *method, plan_of(7.75, 0.25, 7));
  EXPECT_EQ(r.times, (std::vector<double>{7, 7.25, 7.5, 7.75}));
}

TEST(Run, LastStepIsShortenedToHitTheEnd) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 1, {0.5, 0})};
  const auto method = make_method("pece");
  const Ran r = run_through(scene, *method, plan_of(1.125, 0.5));
  EXPECT_EQ(r.times, (std::vector<double>{0, 0.5, 1, 1.125}));
  EXPECT_EQ(r.y[0], 0.5625);
}

TEST(Run, MakesNoTinyLastStep) {
  const auto method = make_method("pece");
  EXPECT_EQ(run_through(single_spring(1, 0), *method, plan_of(0.3, 0.1)).end.steps, 3);  // 3 * 0.1 is above 0.3
  EXPECT_EQ(run_through(single_spring(1, 0), *method, plan_of(0.7, 0.1)).end.steps, 7);  // 7 * 0.1 is above 0.7
  const RunEnd end = run_through(single_spring(1, 0), *method, plan_of(0.6 + 1e-12, 0.1)).end;
  EXPECT_EQ(end.steps, 6);
  EXPECT_EQ(end.time, 0.6 + 1e-12);
}

TEST(Run, AnEmptyIntervalIsNoStep) {
  const auto method = make_method("pece");
  const Ran r = run_through(single_spring(1, 0), *method, plan_of(2, 0.1, 2));
  EXPECT_EQ(r.end.ending, Ending::finished);
  EXPECT_EQ(r.times, (std::vector<double>{2}));
}

TEST(Run, StopsWhenTold) {
  for (const int wanted : {0, 1, 5}) {
    System system(single_spring(1, 0));
    State y = system.initial_state();
    State seen;
    const auto method = make_method("pece");
    int calls = 0;
    const RunEnd end = run(system, *method, y, plan_of(1, 0.125), [&](double, const State& now, const JumpReport&) {
      seen = now;
      return calls++ < wanted;
    });
    EXPECT_EQ(end.ending, Ending::stopped);
    EXPECT_EQ(end.steps, wanted);
    EXPECT_EQ(end.time, 0.125 * wanted);
    EXPECT_EQ(y, seen);
  }
}

// The state and time of a failed run are those of the last call.
void expect_last_good(const Ran& r) {
  EXPECT_EQ(r.end.ending, Ending::diverged);
  ASSERT_FALSE(r.times.empty());
  EXPECT_EQ(r.end.time, r.times.back());
  EXPECT_EQ(r.end.steps, static_cast<long>(r.times.size()) - 1);
  EXPECT_EQ(r.y, r.states.back());
}

TEST(Run, UnstableStepIsADivergenceThatNamesTheNode) {
  Scene scene = single_spring(1e4, 0);
  scene.lattice[0].name = "stem";
  scene.lattice[0].node = {node_setting(0, 1, {1e-3, 0})};
  const auto method = make_method("pece");
  const Ran r = run_through(scene, *method, plan_of(10, 0.05));  // h omega = 3.5, far above 1.287
  expect_last_good(r);
  EXPECT_NE(r.end.reason.find("node (row 0, column 1) of lattice stem"), std::string::npos) << r.end.reason;
  EXPECT_GT(r.end.steps, 2);
}

TEST(Run, BodiesThatMeetInAStepTooLongForThemAreADivergence) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1, {0, 1.9}), disc({0, 0.3}, 0.1, {0, -3.1})};
  const auto method = make_method("pece");
  const Ran r = run_through(scene, *method, plan_of(10, 0.1));
  expect_last_good(r);
  EXPECT_EQ(r.end.steps, 0);
  EXPECT_NE(r.end.reason.find("disc 0 and disc 1 met within one step"), std::string::npos) << r.end.reason;
}

// Spoils one number of the state after three steps.
class Spoiler final : public Method {
 public:
  Spoiler(std::size_t place, double value) : Method({"spoiler", "", 0, 0, false}), place_(place), value_(value) {}
  double step(const OdeSystem&, double, State& y, double h) override {
    if (++steps_ > 3) y[place_] = value_;
    return h;
  }

 private:
  std::size_t place_;
  double value_;
  int steps_ = 0;
};

TEST(Run, NumbersThatAreNotFiniteAreADivergence) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.disc = {disc({0, 0}, 0.1), disc({5, 0}, 0.1)};
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    for (std::size_t place = 0; place < System(scene).size(); ++place) {
      Spoiler method(place, value);
      const Ran r = run_through(scene, method, plan_of(10, 0.1));
      expect_last_good(r);
      EXPECT_EQ(r.end.steps, 3);
      EXPECT_NE(r.end.reason.find("not finite"), std::string::npos) << r.end.reason;
      if (place >= 4) continue;
      EXPECT_NE(r.end.reason.find(place % 2 == 0 ? "disc 0" : "disc 1"), std::string::npos) << r.end.reason;
    }
  }
}

// Forty soft discs that all meet at one point need far more tangential springs than a bed at rest would.
TEST(Run, AsManyContactsAsThereAreAreNoDivergence) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.material[0].young = 1e-3;
  for (int k = 0; k < 40; ++k) scene.disc.push_back(disc({0.3 * k, 0}, 0.1, {-0.3 * k, 0}));
  const auto method = make_method("pece");
  const Ran r = run_through(scene, *method, plan_of(1.2, 5e-3));
  EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  EXPECT_GT(r.y.size(), r.states.front().size());
}

// Says what the loop asks of a method.
class Listener final : public Method {
 public:
  Listener() : Method({"listener", "", 0, 0, false}) {}
  double step(const OdeSystem&, double, State& y, double h) override {
    if (action) action(y);
    return h;
  }
  void restart() override { ++restarts; }
  void state_changed() override { ++changes; }
  std::function<void(State&)> action;
  int restarts = 0, changes = 0;
};

// A jump computes the rates where the next step starts, and a method that is given them must go the same way as one
// that computes them itself. Discs that slide and roll over a lattice that tears.
TEST(Run, RatesHandedOverByAJumpAreThoseThatTheMethodWouldCompute) {
  Scene scene = busy_scene(20);
  for (LinkKind* kind : {&scene.lattice[0].structural, &scene.lattice[0].shear}) kind->strength = 0.05;
  constexpr double h = 0x1p-16;  // s, so that all times are exact
  constexpr int steps = 300;
  int methods = 0;
  for (const MethodInfo& info : method_catalogue()) {
    System system(scene);
    if (info.controlled || info.dense_jacobian || !refusal(info, system).empty()) continue;
    ++methods;
    const auto given = make_method(info.name), alone = make_method(info.name);
    const Ran r = run_through(scene, *given, plan_of(steps * h, h));
    State y = system.initial_state();
    system.jump(0, y);
    int tears = 0, returns = 0;
    for (int n = 0; n < steps; ++n) {
      alone->step(system, n * h, y, h);
      const JumpReport report = system.jump((n + 1) * h, y);
      if (report.flow_jumped()) {
        ++tears;
        alone->restart();
      } else if (report.springs_changed) {
        ++returns;
        alone->state_changed();
      }
    }
    EXPECT_GT(tears, 0) << info.name;
    EXPECT_GT(returns, 10) << info.name;
    EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
    EXPECT_EQ(r.y, y) << info.name;
    EXPECT_EQ(given->evaluations(), alone->evaluations()) << info.name;
  }
  EXPECT_GT(methods, 15);
}

TEST(Method, TakesRatesThatItKnowsOnceAndOnlyForTheirTime) {
  const Scene scene = single_spring(100, 0);
  const System system(scene);
  State y = system.initial_state();
  const State start = y;
  for (const auto& [at, taken] : {std::pair(0.0, true), {1.0, false}}) {
    const auto method = make_method("symplectic_euler");
    y = start;
    State rates(y.size(), 1.0);  // not those of the spring
    method->know(at, rates);
    method->step(system, 0, y, 0.125);
    EXPECT_EQ(y[2] == start[2] + 0.125, taken);
    const State after = y;
    method->step(system, 0, y, 0.125);  // the same time, another state
    State expected(y.size());
    system.rhs(0, after, expected);
    EXPECT_EQ(y[2], after[2] + 0.125 * expected[2]);
    EXPECT_EQ(method->evaluations(), 2);
  }
}

TEST(Run, TearRestartsTheMethodOnce) {
  Scene scene = single_spring(4, 0, 2);
  Listener method;
  method.action = [](State& y) { y[0] += 0.125; };  // torn in the fifth step, at 0.625 m
  run_through(scene, method, plan_of(1, 0.125));
  EXPECT_EQ(method.restarts, 1);
  EXPECT_EQ(method.changes, 0);
}

TEST(Run, ReturnedSpringTellsTheMethodThatItsStateChanged) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.disc = {disc({0, 0.09}, 0.1)};
  scene.wall = {wall({0, 0}, {0, 1})};
  Listener method;
  method.action = [at = System(scene).first_spring()](State& y) { y[at] += 1; };
  run_through(scene, method, plan_of(1, 0.25));
  EXPECT_EQ(method.restarts, 0);
  EXPECT_EQ(method.changes, 4);
}

TEST(Run, ControlledMethodHitsItsStops) {
  Tolerances tolerances;
  const auto method = make_method("odeint_dopri5", tolerances);
  RunPlan plan = plan_of(3, 0.5);
  const std::vector<double> stops{0.3, 0.7, 1.9, 3};
  plan.stop = [&](double t) { return *std::upper_bound(stops.begin(), stops.end() - 1, t); };
  const Ran r = run_through(single_spring(1, 0), *method, plan);
  EXPECT_EQ(r.end.ending, Ending::finished);
  for (const double stop : stops) EXPECT_TRUE(std::count(r.times.begin(), r.times.end(), stop)) << stop;
  EXPECT_EQ(r.times.back(), 3);
  for (std::size_t k = 1; k < r.times.size(); ++k) {
    EXPECT_GT(r.times[k], r.times[k - 1]);
    EXPECT_LE(r.times[k] - r.times[k - 1], 0.5 + 1e-15);
  }
}

TEST(Run, ControlledMethodThatGivesUpIsADivergence) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1, {1e300, 0})};
  scene.wall = {wall({1, 0}, {-1, 0})};
  Tolerances tolerances;
  tolerances.relative = tolerances.absolute = 1e-300;
  const auto method = make_method("odeint_dopri5", tolerances);
  const Ran r = run_through(scene, *method, plan_of(1, 0.5));
  expect_last_good(r);
}

}  // namespace
}  // namespace furrow
