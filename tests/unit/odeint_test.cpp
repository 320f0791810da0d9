// Boost.Odeint behind its adapter: the same as the own methods where it is the same scheme; the controlled method's
// manners.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oscillator.h"

namespace furrow {
namespace {

using namespace test;

TEST(OdeintRk4, IsTheOwnRk4ToRoundOff) {
  const Oscillator system(2, 0.1);
  State own{1, 0};
  State odeint{1, 0};
  const auto one = make_method("rk4");
  const auto other = make_method("odeint_rk4");
  for (int n = 0; n < 100; ++n) {
    one->step(system, n * 0.05, own, 0.05);
    other->step(system, n * 0.05, odeint, 0.05);
    ASSERT_NEAR(own[0], odeint[0], 1e-15 * (n + 1));
    ASSERT_NEAR(own[1], odeint[1], 2e-15 * (n + 1));
  }
}

// The paper's scheme in another hand. Its first step is one of rk4, pece's is Heun's: they differ by h^3/6 x''' at once
// and by nothing else, and the decaying oscillator does not let that grow.
double difference_from_abm2(double h) {
  const Oscillator system(2, 0.1);
  State own{1, 0};
  State odeint{1, 0};
  const auto one = make_method("pece");
  const auto other = make_method("odeint_abm2");
  double greatest = 0;
  const int steps = static_cast<int>(std::lround(5 / h));
  for (int n = 0; n < steps; ++n) {
    one->step(system, n * h, own, h);
    other->step(system, n * h, odeint, h);
    greatest = std::max({greatest, std::fabs(own[0] - odeint[0]), std::fabs(own[1] - odeint[1])});
  }
  return greatest;
}

TEST(OdeintAbm2, DiffersFromPeceByItsFirstStepOnly) {
  const double coarse = difference_from_abm2(0.04);
  const double fine = difference_from_abm2(0.02);
  EXPECT_LT(coarse,
            8.0 * 0.04 * 0.04 * 0.04);  // |x'''| and |v'''| are at most w^4 = 16: 16/6, and as much of the second
  EXPECT_NEAR(std::log2(coarse / fine), 3, 0.2);
}

// From a start that both make exactly - at rest in z, f linear in t - the two recurrences give the same numbers.
struct Ramp final : OdeSystem {
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double t, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = t < 0.15 ? 0 : -4 * y[0] - 0.4 * y[1] + 1;  // nothing happens before the history is full
  }
};

TEST(OdeintAbm2, IsPeceToRoundOffAfterTheSameStart) {
  const Ramp system;
  State own{1, 0};
  State odeint{1, 0};
  const auto one = make_method("pece");
  const auto other = make_method("odeint_abm2");
  for (int n = 0; n < 200; ++n) {
    one->step(system, n * 0.05, own, 0.05);
    other->step(system, n * 0.05, odeint, 0.05);
    ASSERT_NEAR(own[0], odeint[0], 1e-15 * (n + 1)) << n;
    ASSERT_NEAR(own[1], odeint[1], 2e-15 * (n + 1)) << n;
  }
  EXPECT_GT(std::fabs(own[0] - 1), 0.1);
}

// Runs dopri5 to `end` and returns how many steps it took.
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

Tolerances tolerances_of(double relative, double first_step = 1e-4) {
  Tolerances t;
  t.relative = relative;
  t.absolute = relative;
  t.first_step = first_step;
  return t;
}

TEST(Dopri5, ErrorFollowsTheTolerance) {
  double before = 1;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Oscillator system(1, 0.05);
    const auto method = make_method("odeint_dopri5", tolerances_of(tolerance));
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

TEST(Dopri5, TakesFewerStepsThanItsFirstStepWouldMake) {
  const Oscillator system(1, 0.05);
  const auto method = make_method("odeint_dopri5", tolerances_of(1e-6));
  State y{1, 0};
  EXPECT_LT(run_controlled(*method, system, y, 20), 200);
}

TEST(Dopri5, ShortensAFirstStepThatIsTooLong) {
  const Oscillator system(100, 0.05);
  const auto method = make_method("odeint_dopri5", tolerances_of(1e-8, 1.0));
  State y{1, 0};
  EXPECT_LT(method->step(system, 0, y, 1), 0.1);
  EXPECT_GT(method->rejections(), 0);
}

TEST(Dopri5, DoesNotForgetItsStepOverAShortOne) {
  const Oscillator system(1, 0.05);
  const auto method = make_method("odeint_dopri5", tolerances_of(1e-6));
  State y{1, 0};
  double usual = 0;
  for (int k = 0; k < 30; ++k) usual = method->step(system, k, y, 10);
  EXPECT_EQ(method->step(system, 30, y, 1e-6), 1e-6);  // cut by a stop, not by the error
  EXPECT_GT(method->step(system, 31, y, 10), 0.2 * usual);
}

// What grows past the error control only where it does not count.
struct WithLedger final : OdeSystem {
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  std::size_t controlled() const override { return 2; }
  void rhs(double t, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = -y[0];
    dydt[2] = std::sin(1e6 * t);
  }
};

TEST(Dopri5, LedgerTakesNoPartInTheErrorControl) {
  const auto method = make_method("odeint_dopri5", tolerances_of(1e-8));
  State y{1, 0, 0};
  EXPECT_LT(run_controlled(*method, WithLedger(), y, 10), 1000);
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

TEST(Dopri5, GivesUpOnNaNAndLeavesTheStateAsItWas) {
  const auto method = make_method("odeint_dopri5", tolerances_of(1e-6));
  State y{1, 2};
  EXPECT_THROW(method->step(NotANumber(), 0, y, 0.1), Divergence);
  EXPECT_EQ(y, (State{1, 2}));
  EXPECT_LT(method->evaluations(), 1000);
  EXPECT_GT(method->rejections(), 10);
}

// NaN where the error control does not look.
struct BrokenLedger final : OdeSystem {
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  std::size_t controlled() const override { return 2; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = -y[0];
    dydt[2] = std::numeric_limits<double>::quiet_NaN();
  }
};

TEST(Dopri5, GivesUpOnNaNInTheLedgerToo) {
  const auto method = make_method("odeint_dopri5", tolerances_of(1e-6));
  State y{1, 2, 0};
  EXPECT_THROW(method->step(BrokenLedger(), 0, y, 0.1), Divergence);
  EXPECT_EQ(y, (State{1, 2, 0}));
}

// Cannot be computed beyond x = 1: long trial steps end there, the solution x = 1 - e^-t does not.
struct Cliff final : OdeSystem {
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    if (y[0] > 1) {
      ++falls;
      throw Divergence("beyond the cliff");
    }
    dydt[0] = y[1];
    dydt[1] = -y[1];
  }
  mutable int falls = 0;
};

TEST(Dopri5, RecoversWhenATrialStepLeavesWhatCanBeComputed) {
  const Cliff system;
  const auto method = make_method("odeint_dopri5", tolerances_of(1e-6, 5.0));
  State y{0, 1};
  double t = 0;
  while (t < 2) t += method->step(system, t, y, 5);
  EXPECT_GT(system.falls, 0);
  EXPECT_GT(method->rejections(), 0);
  EXPECT_NEAR(y[0], 1 - std::exp(-t), 1e-5);
}

TEST(Dopri5, NoticesAStateThatWasTouched) {
  const Oscillator system(1, 0);
  const auto method = make_method("odeint_dopri5", tolerances_of(1e-6, 0.1));
  State y{1, 0};
  for (int k = 0; k < 5; ++k) method->step(system, k, y, 0.1);
  y = {0, 3};
  method->state_changed();
  const double h = method->step(system, 5, y, 0.01);
  EXPECT_NEAR(y[0], 3 * std::sin(h), 1e-8);
  EXPECT_NEAR(y[1], 3 * std::cos(h), 1e-8);
}

}  // namespace
}  // namespace furrow
