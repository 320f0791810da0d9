// The forms of the AB2/AM2 pair, AB2 alone and symplectic Euler: recurrences written out by hand, stability limits from
// their characteristic polynomials, what survives a restart and steps of unequal length.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "methods/method.h"
#include "methods/stability.h"
#include "oscillator.h"

namespace furrow {
namespace {

using Complex = std::complex<double>;

// y' = lambda y as a real system of the two parts, all z but for one resting position.
struct Linear final : OdeSystem {
  explicit Linear(Complex rate) : lambda(rate) {}
  std::size_t size() const override { return 4; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = 0;
    dydt[2] = lambda.real() * y[2] - lambda.imag() * y[3];
    dydt[3] = lambda.imag() * y[2] + lambda.real() * y[3];
  }
  Complex lambda;
};

double size_after(const std::string& name, Complex z, int steps) {
  const auto method = make_method(name);
  const Linear system(z);
  State y{0, 0, 1, 0};
  for (int n = 0; n < steps && std::fabs(y[2]) + std::fabs(y[3]) < 1e100; ++n) method->step(system, n, y, 1);
  return std::hypot(y[2], y[3]);
}

// y' = lambda y by each form, with h = 1 and z = lambda: in PEC the rate of the prediction is kept.
std::vector<Complex> by_hand(const std::string& form, Complex z, int steps) {
  std::vector<Complex> y{1};
  Complex rate = z;
  Complex before = z;
  for (int n = 0; n < steps; ++n) {
    const Complex now = y.back();
    if (form != "pec") rate = z * now;
    if (n == 0) before = rate;
    const Complex predicted = now + 1.5 * rate - 0.5 * before;
    Complex next = now + 0.5 * (z * predicted + rate);
    if (form == "pecece") next = now + 0.5 * (z * next + rate);
    if (form == "ab2") next = predicted;
    y.push_back(next);
    before = rate;
    rate = z * predicted;
  }
  return y;
}

TEST(AdamsForms, AreTheRecurrencesWrittenOut) {
  for (const char* form : {"pec", "pece", "pecece", "ab2"}) {
    const Complex z(-0.1, 0.3);
    const std::vector<Complex> want = by_hand(form, z, 50);
    const auto method = make_method(form);
    State y{0, 0, 1, 0};
    for (int n = 0; n < 50; ++n) {
      method->step(Linear(z), n, y, 1);
      ASSERT_NEAR(y[2], want[n + 1].real(), 1e-15 * (n + 2)) << form << n;  // one or two roundings a step
      ASSERT_NEAR(y[3], want[n + 1].imag(), 1e-15 * (n + 2)) << form << n;
    }
  }
}

struct Limits {
  const char* form;
  double real, imaginary;
};

// Where the largest root leaves the unit circle:
//   pec     r^2 (r - 1) = z/2 (4 r^2 - 3 r + 1)
//   pece    r^2 = r (1 + z + 3/4 z^2) - z^2/4
//   pecece  r^2 = r (1 + z + z^2/2 + 3/8 z^3) - z^3/8
//   ab2     r^2 = r (1 + 3/2 z) - z/2
constexpr Limits limits[] = {{"pec", 0.5, 0.667}, {"pece", 2, 1.287}, {"pecece", 1.478, 1.691}, {"ab2", 1, 0}};

TEST(AdamsForms, DecayOnTheRealAxisUpToTheirLimits) {
  for (const Limits& l : limits) {
    EXPECT_LT(size_after(l.form, -0.99 * l.real, 5000), 1e-3) << l.form;
    EXPECT_GT(size_after(l.form, -1.01 * l.real, 5000), 1e3) << l.form;
  }
}

TEST(AdamsForms, OscillateWithoutGrowthUpToTheirLimits) {
  for (const Limits& l : limits) {
    if (l.imaginary == 0) continue;
    EXPECT_LT(size_after(l.form, {0, 0.99 * l.imaginary}, 5000), 1) << l.form;
    EXPECT_GT(size_after(l.form, {0, 1.01 * l.imaginary}, 5000), 1e3) << l.form;
  }
}

TEST(AdamsBashforth2, AmplifiesAnyOscillationByAQuarterOfTheFourthPower) {
  const double q = 0.1;
  const double want = std::pow(1 + q * q * q * q / 4, 10'000);
  EXPECT_NEAR(size_after("ab2", {0, q}, 10'000), want, 0.02 * want);  // next term: q^2 of the first one
}

TEST(AdamsForms, StayOfSecondOrderWithUnequalSteps) {
  for (const char* form : {"pec", "pecece", "ab2"}) {
    const auto error = [&](int steps) {
      const Complex lambda(-0.1, 1);
      const auto method = make_method(form);
      State y{0, 0, 1, 0};
      double t = 0;
      for (int k = 0; k < steps; ++k) {
        const double h = (k % 2 == 0 ? 0.5 : 1.5) * 6 / steps;
        method->step(Linear(lambda), t, y, h);
        t += h;
      }
      return std::abs(Complex(y[2], y[3]) - std::exp(6.0 * lambda));
    };
    EXPECT_NEAR(std::log2(error(200) / error(800)) / 2, 2, 0.1) << form;
  }
}

// A sliding contact touches its spring after every step. The history is kept, or each step would be Heun's.
TEST(AdamsForms, KeepTheirHistoryWhenOnlyTheStateWasTouched) {
  for (const char* form : {"pec", "pece", "pecece", "ab2"}) {
    const auto notified = make_method(form);
    const auto untold = make_method(form);
    const Linear system({-0.1, 1});
    State one{0, 0, 1, 0};
    State other = one;
    for (int n = 0; n < 10; ++n) {
      notified->step(system, n * 0.1, one, 0.1);
      untold->step(system, n * 0.1, other, 0.1);
      notified->state_changed();
    }
    EXPECT_EQ(one, other) << form;
  }
}

TEST(SymplecticEuler, IsTheRecurrenceWrittenOut) {
  const test::Oscillator system(2, 0.1);
  const auto method = make_method("symplectic_euler");
  State y{1, 0};
  double x = 1;
  double v = 0;
  for (int n = 0; n < 50; ++n) {
    method->step(system, n * 0.1, y, 0.1);
    v += 0.1 * (-4 * x - 0.4 * v);
    x += 0.1 * v;
    ASSERT_NEAR(y[0], x, 1e-15 * (n + 1));
    ASSERT_NEAR(y[1], v, 2e-15 * (n + 1));
  }
}

TEST(SymplecticEuler, KeepsItsOwnEnergyWithoutDamping) {
  const test::Oscillator system(1, 0);
  const auto method = make_method("symplectic_euler");
  State y{1, 0};
  const double h = 1;
  for (int n = 0; n < 1000; ++n) {
    method->step(system, n * h, y, h);
    EXPECT_NEAR(y[0] * y[0] + y[1] * y[1] - h * y[0] * y[1], 1, 1e-12);  // its conserved quantity
  }
}

TEST(LargestStableStep, OfEachOwnMethodIsThatOfItsPolynomial) {
  const double golden = std::sqrt(1.25) - 0.5;  // sqrt(1 + zeta^2) - zeta at zeta = 1/2
  EXPECT_NEAR(largest_stable_step("symplectic_euler", {1, 0}), 2, 0.002);
  EXPECT_NEAR(largest_stable_step("symplectic_euler", {1, 0.5}), 2 * golden, 0.002);
  EXPECT_NEAR(largest_stable_step("pece", {1, 0}), 1.287, 0.002);
  EXPECT_NEAR(largest_stable_step("pec", {1, 0}), 0.667, 0.001);
  EXPECT_NEAR(largest_stable_step("pecece", {1, 0}), 1.691, 0.002);
  EXPECT_NEAR(largest_stable_step("rk4", {1, 0}), 2.828, 0.003);
}

// A step is limited by the decay at 2 zeta omega alone, as it is at a ratio of 1e4 already; 0.1 % is the search's.
TEST(LargestStableStep, FallsWithTheDampingRatioHoweverLarge) {
  for (const MethodInfo& method : method_catalogue()) {
    const double limit = largest_stable_step(method.name, {1, 1e4});
    for (const double zeta : {3e6, 1e9, 1e17, 1e300}) {
      const double found = largest_stable_step(method.name, {1, zeta});
      if (limit < 1e300)
        EXPECT_NEAR(found * (zeta / 1e4), limit, 1e-3 * limit) << method.name << " at " << zeta;
      else
        EXPECT_EQ(found, limit) << method.name << " at " << zeta;
    }
  }
}

TEST(LargestStableStep, OfWhatIsNotFiniteIsNoneForEveryMethodOfFixedSteps) {
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN(), endless = HUGE_VAL;
  for (const MethodInfo& method : method_catalogue()) {
    if (method.controlled) continue;
    for (const Oscillator& o : {Oscillator{1, endless}, {1, no_number}, {endless, 0.5}, {no_number, 0.5}})
      EXPECT_EQ(largest_stable_step(method.name, o), 0) << method.name << " at " << o.omega << ", " << o.zeta;
  }
}

}  // namespace
}  // namespace furrow
