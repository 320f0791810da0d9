// Boost.Odeint's controlled steppers in their adapter: order, tolerance, and what they do when no step is good.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "oscillator.h"

namespace furrow {
namespace {

using namespace test;

std::vector<MethodInfo> controlled_methods() {
  std::vector<MethodInfo> list(method_catalogue().begin(), method_catalogue().end());
  std::erase_if(list, [](const MethodInfo& info) { return !info.controlled || info.family != "odeint"; });
  return list;
}

// With a tolerance that nothing exceeds, the steps are those asked for and the order is that of the formula. The
// extrapolation takes its second row (order 4) then: the first that can be checked.
TEST(OdeintControlled, OrderOfTheFormula) {
  const std::map<std::string, std::pair<double, int>> expected{{"odeint_cash_karp54", {5, 30}},
                                                               {"odeint_dopri5", {5, 30}},
                                                               {"odeint_fehlberg78", {8, 15}},
                                                               {"odeint_bulirsch_stoer", {4, 30}},
                                                               {"odeint_rosenbrock4", {4, 60}}};
  for (const MethodInfo& info : controlled_methods()) {
    ASSERT_TRUE(expected.count(info.name)) << info.name;
    const auto [order, coarse] = expected.at(info.name);
    const auto error = [&](int steps) {
      const Oscillator system(2, 0.1);
      const auto method = make_method(info.name, tolerances_of(1e6, 1));
      State y{1, 0};
      advance(*method, system, y, 0, 6.0 / steps, steps);
      EXPECT_EQ(method->rejections(), 0) << info.name;
      const double wd = 2 * std::sqrt(0.99), t = 6;
      const double x = std::exp(-0.2 * t) * (std::cos(wd * t) + 0.2 / wd * std::sin(wd * t));
      const double v = -std::exp(-0.2 * t) * 4 / wd * std::sin(wd * t);
      return std::hypot(2 * (y[0] - x), y[1] - v);
    };
    EXPECT_NEAR(std::log2(error(coarse) / error(4 * coarse)) / 2, order, 0.25) << info.name;
  }
}

// v' = 4 t^3: exact for a formula of order 4 or more whose stages stand at the right times. What remains of rosenbrock4
// is its difference quotient for df/dt, off by 2^-26 t/2 12 t = 1e-7 or less.
struct CubicInTime final : OdeSystem {
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double t, const State& /*y*/, State& dydt) const override {
    dydt[0] = 0;
    dydt[1] = 4 * t * t * t;
  }
};

TEST(OdeintControlled, AForceOfTimeIsSeenAtTheRightTimes) {
  for (const MethodInfo& info : controlled_methods()) {
    State y{0, 0};
    ASSERT_EQ(make_method(info.name, tolerances_of(1e6, 1))->step(CubicInTime(), 0.5, y, 1), 1) << info.name;
    EXPECT_NEAR(y[1], 1.5 * 1.5 * 1.5 * 1.5 - 0.5 * 0.5 * 0.5 * 0.5, info.dense_jacobian ? 1e-7 : 1e-14) << info.name;
  }
}

// Runs to `end` and returns how many steps it took.
int run_controlled(Method& method, const OdeSystem& system, State& y, double end, double most = 10) {
  double t = 0;
  int steps = 0;
  while (t < end && steps < 100'000) {
    const double h = std::min(most, end - t);
    const double taken = method.step(system, t, y, h);
    EXPECT_GT(taken, 0);
    EXPECT_LE(taken, h);
    t = taken == end - t ? end : t + taken;
    ++steps;
  }
  return steps;
}

TEST(OdeintControlled, ErrorFollowsTheTolerance) {
  for (const MethodInfo& info : controlled_methods()) {
    SCOPED_TRACE(info.name);
    double before = 1;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const Oscillator system(1, 0.05);
      const auto method = make_method(info.name, tolerances_of(tolerance));
      State y{1, 0};
      run_controlled(*method, system, y, 20);
      const double wd = std::sqrt(1 - 0.0025);
      const double want = std::exp(-1.0) * (std::cos(wd * 20) + 0.05 / wd * std::sin(wd * 20));
      const double error = std::fabs(y[0] - want);
      EXPECT_LT(error, 20 * tolerance);  // some 20 s of steps whose error a unit of time is below the tolerance
      EXPECT_LT(error, before);
      before = error;
    }
  }
}

TEST(OdeintControlled, TakesFewerStepsThanItsFirstStepWouldMake) {
  for (const MethodInfo& info : controlled_methods()) {
    SCOPED_TRACE(info.name);
    const Oscillator system(1, 0.05);
    const auto method = make_method(info.name, tolerances_of(1e-6));
    State y{1, 0};
    EXPECT_LT(run_controlled(*method, system, y, 20), 200);
  }
}

TEST(OdeintControlled, ShortensAFirstStepThatIsTooLong) {
  for (const MethodInfo& info : controlled_methods()) {
    SCOPED_TRACE(info.name);
    const Oscillator system(100, 0.05);
    const auto method = make_method(info.name, tolerances_of(1e-8, 1.0));
    State y{1, 0};
    EXPECT_LT(method->step(system, 0, y, 1), 0.1);
    EXPECT_GT(method->rejections(), 0);
  }
}

TEST(OdeintControlled, DoesNotForgetItsStepOverAShortOne) {
  for (const MethodInfo& info : controlled_methods()) {
    SCOPED_TRACE(info.name);
    const Oscillator system(1, 0.05);
    const auto method = make_method(info.name, tolerances_of(1e-6));
    State y{1, 0};
    double usual = 0;
    for (int k = 0; k < 30; ++k) usual = method->step(system, k, y, 10);
    EXPECT_EQ(method->step(system, 30, y, 1e-6), 1e-6);  // cut by a stop, not by the error
    EXPECT_GT(method->step(system, 31, y, 10), 0.2 * usual);
  }
}

TEST(OdeintControlled, LedgerTakesNoPartInTheErrorControl) {
  for (const MethodInfo& info : controlled_methods()) {
    SCOPED_TRACE(info.name);
    const auto method = make_method(info.name, tolerances_of(1e-8));
    State y{1, 0, 0};
    const Beside wild([](double t) { return std::sin(1e6 * t); });
    EXPECT_LT(run_controlled(*method, wild, y, 10), 1000);
  }
}

// Nothing but NaN: no step is short enough.
struct NotANumber final : OdeSystem {
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = std::numeric_limits<double>::quiet_NaN();
  }
};

TEST(OdeintControlled, GivesUpOnNaNAndLeavesTheStateAsItWas) {
  for (const MethodInfo& info : controlled_methods()) {
    SCOPED_TRACE(info.name);
    const auto method = make_method(info.name, tolerances_of(1e-6));
    State y{1, 2};
    EXPECT_THROW(method->step(NotANumber(), 0, y, 0.1), Divergence);
    EXPECT_EQ(y, (State{1, 2}));
    EXPECT_LT(method->evaluations(), 2000);  // 60 tries
    EXPECT_GT(method->rejections(), 10);
  }
}

TEST(OdeintControlled, GivesUpOnNaNInTheLedgerToo) {
  for (const MethodInfo& info : controlled_methods()) {
    SCOPED_TRACE(info.name);
    const auto method = make_method(info.name, tolerances_of(1e-6));
    State y{1, 2, 0};
    const Beside broken([](double) { return std::numeric_limits<double>::quiet_NaN(); });
    EXPECT_THROW(method->step(broken, 0, y, 0.1), Divergence);
    EXPECT_EQ(y, (State{1, 2, 0}));
  }
}

// Its square is beyond all numbers, and the state is not: that is no good step.
TEST(OdeintControlled, AnErrorBeyondAllNumbersIsTooLarge) {
  for (const MethodInfo& info : controlled_methods()) {
    const auto method = make_method(info.name, tolerances_of(1e-200, 0.1));
    State y{1, 0};
    try {
      method->step(Oscillator(1, 0), 0, y, 0.1);
    } catch (const Divergence&) {
    }
    EXPECT_GT(method->rejections(), 0) << info.name;
  }
}

// An oscillator, beside it numbers that come and go with contacts: the first two swing too, w times as fast, all others
// rest. (To what does not act on itself Fehlberg's pair is blind.)
struct ComesAndGoes final : OdeSystem {
  ComesAndGoes(double w, std::size_t room) : frequency(w), rooms(room) {}
  std::size_t size() const override { return 2 + rooms; }
  std::size_t positions() const override { return 1; }
  std::size_t lasting() const override { return 2; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt.assign(y.size(), 0);
    dydt[0] = y[1];
    dydt[1] = -y[0];
    dydt[2] = frequency * y[3];
    dydt[3] = frequency * (1 - y[2]);
  }
  double frequency;
  std::size_t rooms;
};

std::vector<double> first_steps(const std::string& name, const OdeSystem& system) {
  const auto method = make_method(name, tolerances_of(1e-6));
  State y(system.size(), 0.0);
  y[0] = 1;
  std::vector<double> steps;
  for (double t = 0; steps.size() < 30; t += steps.back()) steps.push_back(method->step(system, t, y, 10));
  return steps;
}

TEST(OdeintControlled, RoomForWhatComesAndGoesChangesNoStep) {
  for (const MethodInfo& info : controlled_methods()) {
    const std::vector<double> one = first_steps(info.name, ComesAndGoes(50, 2));
    EXPECT_EQ(one, first_steps(info.name, ComesAndGoes(50, 3))) << info.name;
    EXPECT_EQ(one, first_steps(info.name, ComesAndGoes(50, 17))) << info.name;
  }
}

TEST(OdeintControlled, WhatComesAndGoesCountsInTheErrorControl) {
  for (const MethodInfo& info : controlled_methods()) {
    const double slow = first_steps(info.name, ComesAndGoes(0, 2)).back();
    const double fast = first_steps(info.name, ComesAndGoes(50, 2)).back();
    EXPECT_LT(fast, 0.2 * slow) << info.name << ": what turns fifty times as fast cannot be followed by its steps";
  }
}

// Hairer and Wanner 1996, section IV.7: the next step is 0.9 h / error^(1/4), six times as long at most, a fifth at
// least, and an error of 1 is the largest good one.
TEST(Rosenbrock4, ChoosesItsStepsByTheFourthRootOfTheError) {
  const auto two_steps = [](const Oscillator& system, double first) {
    const auto method = make_method("odeint_rosenbrock4", tolerances_of(1e-6, first));
    State y{1, 0};
    const double one = method->step(system, 0, y, 100), other = method->step(system, one, y, 100);
    return std::pair(one, other);
  };
  double good = 1e-3, bad = 10;
  for (int k = 0; k < 50; ++k) {
    const double h = 0.5 * (good + bad);
    (two_steps(Oscillator(1, 0), h).first == h ? good : bad) = h;
  }
  EXPECT_NEAR(two_steps(Oscillator(1, 0), good).second, 0.9 * good, 1e-6 * good);
  EXPECT_NEAR(two_steps(Oscillator(1, 0), bad).first, 0.9 * bad, 1e-6 * bad);
  EXPECT_NEAR(two_steps(Oscillator(1, 0), 1e-4).second, 6e-4, 1e-18) << "no error to speak of";
  EXPECT_NEAR(two_steps(Oscillator(1, 0), 4.8 * bad).first, 4.8 / 5 * bad, 1e-9) << "the formula says 5.3";
}

TEST(OdeintControlled, RecoversWhenATrialStepLeavesWhatCanBeComputed) {
  for (const MethodInfo& info : controlled_methods()) {
    SCOPED_TRACE(info.name);
    const Cliff system(1, false);
    const auto method = make_method(info.name, tolerances_of(1e-6, 5.0));
    State y{0, 1};
    double t = 0;
    while (t < 2) t += method->step(system, t, y, 5);
    EXPECT_GT(system.falls, 0);
    EXPECT_GT(method->rejections(), 0);
    EXPECT_NEAR(y[0], 1 - std::exp(-t), 1e-5);
  }
}

TEST(OdeintControlled, NoticesAStateThatWasTouched) {
  for (const MethodInfo& info : controlled_methods()) {
    SCOPED_TRACE(info.name);
    const Oscillator system(1, 0);
    const auto method = make_method(info.name, tolerances_of(1e-6, 0.1));
    State y{1, 0};
    for (int k = 0; k < 5; ++k) method->step(system, k, y, 0.1);
    y = {0, 3};
    method->state_changed();
    const double h = method->step(system, 5, y, 0.01);
    EXPECT_NEAR(y[0], 3 * std::sin(h), 1e-8);
    EXPECT_NEAR(y[1], 3 * std::cos(h), 1e-8);
  }
}

}  // namespace
}  // namespace furrow
