// Furrow's own methods with error control: what each step is, checked against formulas written out here, and the
// properties that all of them must have.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oscillator.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

constexpr const char* own[] = {"pece_adaptive", "rkc"};

Tolerances tolerances_of(double both, double first_step = 1e-3) {
  return {.relative = both, .absolute = both, .first_step = first_step};
}

// So loose that every step is accepted as asked for.
Tolerances no_control(double step) { return tolerances_of(1e30, step); }

// The lengths of the steps taken.
std::vector<double> drive(Method& method, const OdeSystem& system, State& y, double end, double most = 10) {
  std::vector<double> steps;
  for (double t = 0; t < end && steps.size() < 1'000'000;) {
    steps.push_back(method.step(system, t, y, std::min(most, end - t)));
    EXPECT_GT(steps.back(), 0);
    EXPECT_LE(steps.back(), std::min(most, end - t));
    t = steps.back() == end - t ? end : t + steps.back();
  }
  return steps;
}

double oscillator_error(const std::string& name, double tolerance) {
  const Oscillator system(1, 0.05);
  const auto method = make_method(name, tolerances_of(tolerance));
  State y{1, 0};
  drive(*method, system, y, 20);
  const double wd = std::sqrt(1 - 0.0025);
  return std::fabs(y[0] - std::exp(-1.0) * (std::cos(wd * 20) + 0.05 / wd * std::sin(wd * 20)));
}

// The error of a step, h^3, is held at the tolerance; there are 1/h steps: the error at the end goes as its power 2/3.
TEST(Controlled, ErrorFollowsTheTolerance) {
  for (const char* name : own) {
    const double slope = std::log10(oscillator_error(name, 1e-5) / oscillator_error(name, 1e-8)) / 3;
    EXPECT_NEAR(slope, 2.0 / 3, 0.07) << name;
    EXPECT_LT(oscillator_error(name, 1e-8), 4e-5) << name;  // 9 (1e-8)^(2/3)
  }
}

TEST(Controlled, ShortensAFirstStepThatIsTooLong) {
  for (const char* name : own) {
    const Oscillator system(100, 0.05);
    const auto method = make_method(name, tolerances_of(1e-8, 1.0));
    State y{1, 0};
    EXPECT_LT(method->step(system, 0, y, 1), 0.1) << name;
    EXPECT_GT(method->rejections(), 0) << name;
  }
}

TEST(Controlled, DoesNotForgetItsStepOverAShortOne) {
  for (const char* name : own) {
    const Oscillator system(1, 0.05);
    const auto method = make_method(name, tolerances_of(1e-6));
    State y{1, 0};
    double usual = 0;
    for (int k = 0; k < 60; ++k) usual = method->step(system, 0, y, 10);
    EXPECT_EQ(method->step(system, 0, y, 1e-6), 1e-6) << name;  // cut by a stop, not by the error
    EXPECT_GT(method->step(system, 0, y, 10), 0.2 * usual) << name;
  }
}

TEST(Controlled, LedgerTakesNoPartInTheErrorControl) {
  const Beside wild([](double t) { return 1e3 * std::sin(1e6 * t); });
  const Beside tame([](double) { return 0.0; });
  for (const char* name : own) {
    State one{1, 0, 0};
    State other = one;
    EXPECT_EQ(drive(*make_method(name, tolerances_of(1e-6)), wild, one, 10),
              drive(*make_method(name, tolerances_of(1e-6)), tame, other, 10))
        << name;
  }
}

TEST(Controlled, GivesUpOnNaNAndLeavesTheStateAsItWas) {
  const Beside broken([](double) { return std::numeric_limits<double>::quiet_NaN(); });
  for (const char* name : own) {
    const auto method = make_method(name, tolerances_of(1e-6));
    State y{1, 2, 0};
    EXPECT_THROW(method->step(broken, 0, y, 0.1), Divergence) << name;
    EXPECT_EQ(y, (State{1, 2, 0})) << name;
    EXPECT_LT(method->evaluations(), 1000) << name;
    y = {std::nan(""), 0};
    EXPECT_THROW(method->step(Oscillator(1, 0), 0, y, 0.1), Divergence) << name;
    y = {1, 0};
    method->restart();
    EXPECT_GT(method->step(Oscillator(1, 0), 0, y, 0.1), 0) << name;
  }
}

TEST(Controlled, RecoversWhenATrialStepLeavesWhatCanBeComputed) {
  for (const char* name : own) {
    const Cliff system(1.0001, true);
    const auto method = make_method(name, tolerances_of(1e-7, 5.0));
    State y{0, 1};
    double t = 0;
    while (t < 2) t += method->step(system, t, y, 5);
    EXPECT_GT(system.falls, 0) << name;
    EXPECT_NEAR(y[0], std::sin(t), 1e-4) << name;
  }
}

TEST(Controlled, NoticesAStateThatWasTouched) {
  for (const char* name : own) {
    const auto method = make_method(name, tolerances_of(1e-6, 0.1));
    State y{1, 0};
    for (int k = 0; k < 5; ++k) method->step(Oscillator(1, 0), k, y, 0.01);
    y = {0, 3};
    method->restart();
    const double h = method->step(Oscillator(1, 0), 5, y, 1e-3);
    EXPECT_NEAR(y[0], 3 * std::sin(h), 1e-8) << name;
    EXPECT_NEAR(y[1], 3 * std::cos(h), 1e-8) << name;
  }
}

// A heavily damped disc falls on a frictional floor, sliding: touch, sliding, sticking, all of them kinks.
TEST(Controlled, DoesNotGrindToAHaltAtKinks) {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.contact.damping_factor = 20;
  scene.contact.friction = 0.5;
  scene.contact.rolling_friction = 0.1;
  scene.disc = {disc({0, 0.02}, 0.01, {0.1, 0}, 3)};
  scene.wall = {wall({0, 0}, {0, 1})};
  for (const char* name : own) {
    System system(scene);
    State y = system.initial_state();
    const auto method = make_method(name, {.relative = 1e-4, .absolute = 1e-6, .first_step = 1e-4});
    const RunEnd end = run(system, *method, y, {.start = 0, .end = 0.3, .step = 1e-2, .stop = {}},
                           [](double, const State&, const JumpReport&) { return true; });
    EXPECT_EQ(end.ending, Ending::finished) << name << end.reason;
    EXPECT_LT(method->evaluations(), 20'000) << name;
  }
}

// y' = lambda y by the formulas of predictor and corrector with the steps that the method took.
TEST(PeceAdaptive, IsTheVariableStepRecurrenceWrittenOut) {
  const Decay system;
  const auto method = make_method("pece_adaptive", tolerances_of(1e-5));
  State y{0, 0, 1};
  const std::vector<double> steps = drive(*method, system, y, 3);
  double z = 1;
  double before = 0;
  double h_before = 0;
  for (const double h : steps) {
    // The straight line through the last two rates, integrated over the step.
    const double slope = h_before > 0 ? (-z - before) / h_before : 0;
    const double predicted = z - h * z + 0.5 * h * h * slope;
    before = -z;
    z += 0.5 * h * (before - predicted);
    h_before = h;
  }
  EXPECT_GT(steps.size(), 30U);
  EXPECT_GT(*std::max_element(steps.begin(), steps.end()), 3 * steps.front());
  EXPECT_NEAR(y[2], z, 1e-15 * static_cast<double>(steps.size()));
}

TEST(PeceAdaptive, TakesTwoEvaluationsAStepAndOneForARejection) {
  const Oscillator system(10, 0.05);
  const auto method = make_method("pece_adaptive", tolerances_of(1e-6, 1.0));
  State y{1, 0};
  const auto steps = static_cast<long>(drive(*method, system, y, 3).size());
  EXPECT_GT(method->rejections(), 0);
  EXPECT_EQ(method->evaluations(), 2 * steps + method->rejections());
  EXPECT_EQ(method->evaluations(), system.calls);
}

// z' = -rate z, and a position that rests
struct StiffDecay final : OdeSystem {
  explicit StiffDecay(double of) : rate(of) {}
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = 0;
    dydt[2] = -rate * y[2];
  }
  double rate;
};

// R(z) = 1 - b T(w0) + b T(w0 + w1 z) with the closed forms of Chebyshev's polynomials: T(cosh a) = cosh(s a).
double stability_polynomial(int s, double z) {
  const double w0 = 1 + 2.0 / 13 / (s * s);
  const double a = std::acosh(w0);
  const double t = std::cosh(s * a);
  const double dt = s * std::sinh(s * a) / std::sinh(a);
  const double ddt = (s * s * t - s * std::sinh(s * a) * w0 / std::sinh(a)) / (w0 * w0 - 1);
  const double b = ddt / (dt * dt);
  const double x = w0 + dt / ddt * z;
  const double t_of_x = std::fabs(x) <= 1 ? std::cos(s * std::acos(x))
                                          : (s % 2 == 0 || x > 0 ? 1 : -1) * std::cosh(s * std::acosh(std::fabs(x)));
  return 1 - b * t + b * t_of_x;
}

TEST(RungeKuttaChebyshev, IsItsStabilityPolynomialInClosedForm) {
  for (const double rate : {0.5, 3.0, 20.0, 400.0, 5000.0}) {
    const StiffDecay system(rate);
    const auto method = make_method("rkc", no_control(1));
    State y{0, 0, 1};
    ASSERT_EQ(method->step(system, 0, y, 1), 1);
    const int s = std::max(2, 1 + static_cast<int>(std::sqrt(1 + 1.54 * 1.2 * rate)));
    EXPECT_NEAR(y[2], stability_polynomial(s, -rate), 1e-9) << rate;
    EXPECT_LT(std::fabs(y[2]), 0.97) << rate;
  }
}

TEST(RungeKuttaChebyshev, StagesGrowAsTheRootOfTheStiffness) {
  const auto evaluations = [](double rate) {
    const auto method = make_method("rkc", no_control(1));
    State y{0, 0, 1};
    for (int n = 0; n < 100; ++n) {
      method->step(StiffDecay(rate), n, y, 1);
      y[2] = 1;
      method->state_changed();
    }
    return static_cast<double>(method->evaluations());
  };
  EXPECT_NEAR(evaluations(40'000) / evaluations(400), 10, 1);
}

TEST(RungeKuttaChebyshev, IsOfSecondOrderAlsoInTime) {
  const auto error = [](int steps) {
    const auto method = make_method("rkc", no_control(1.0 / steps));
    State y{0, 0, 0};
    advance(*method, Clock(), y, 0.5, 1.0 / steps, steps);
    return std::fabs(y[2] - (std::exp(1.5) - std::exp(0.5)));
  };
  EXPECT_NEAR(std::log2(error(20) / error(80)) / 2, 2, 0.1);
}

// The stiffness jumps up by a thousand: the kept estimate is too low, the error says so, and the step is made again.
struct Stiffening final : OdeSystem {
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  void rhs(double t, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = 0;
    dydt[2] = (t < 1 ? -10 : -10'000) * (y[2] - std::sin(t));
  }
};

TEST(RungeKuttaChebyshev, NoticesThatTheSystemHasBecomeStiffer) {
  const auto method = make_method("rkc", tolerances_of(1e-4));
  State y{0, 0, 0};
  drive(*method, Stiffening(), y, 3, 0.05);
  EXPECT_NEAR(y[2], std::sin(3.0), 1e-3);
  EXPECT_LT(method->evaluations(), 3'000);  // PECE needs 20,000 to stay stable
}

}  // namespace
}  // namespace furrow
