// Integration methods on problems with a solution in closed form: order, recurrence, stability, catalogue.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <set>

#include "counting_system.h"
#include "methods/method.h"
#include "oscillator.h"

namespace furrow {
namespace {

using namespace test;

// Distance in phase space from the solution of x'' + 2 zeta w x' + w^2 x = 0 with x = 1, v = 0 at t = 0. The whole
// distance: at some times the leading error of the position alone passes through zero, and a slope taken there is too
// high.
double error_of(const State& y, double w, double zeta, double t) {
  const double wd = w * std::sqrt(1 - zeta * zeta);
  const double decay = std::exp(-zeta * w * t);
  const double x = decay * (std::cos(wd * t) + zeta * w / wd * std::sin(wd * t));
  const double v = -decay * w * w / wd * std::sin(wd * t);
  return std::hypot(w * (y[0] - x), y[1] - v);
}

double error_at(const std::string& name, const Oscillator& system, double end, int steps) {
  State y{1, 0};
  const auto method = make_method(name);
  advance(*method, system, y, 0, end / steps, steps);
  return error_of(y, system.frequency, system.ratio, end);
}

// Slope of the error between 150 and 600 steps over about two periods: h w from 0.08 to 0.02, where the next term of
// the error is some percent of the first one.
double observed_order(const std::string& name, double ratio) {
  const Oscillator system(2, ratio);
  return std::log2(error_at(name, system, 6, 150) / error_at(name, system, 6, 600)) / 2;
}

TEST(Order, IsWhatTheCatalogueSaysWithDamping) {
  for (const MethodInfo& info : method_catalogue()) {
    if (info.controlled || info.conservative) continue;
    EXPECT_NEAR(observed_order(info.name, 0.2), info.order, 0.15) << info.name;
  }
}

TEST(Order, IsWhatTheCatalogueSaysWithoutDamping) {
  for (const MethodInfo& info : method_catalogue()) {
    if (info.controlled) continue;
    EXPECT_NEAR(observed_order(info.name, 0), info.order, 0.15) << info.name;
  }
}

TEST(Order, HoldsForATimeDependentRightHandSide) {
  for (const MethodInfo& info : method_catalogue()) {
    if (info.controlled) continue;
    const auto error = [&](int steps) {
      State y{0, 0, 0};
      const auto method = make_method(info.name);
      advance(*method, Clock(), y, 0.5, 1.0 / steps, steps);
      return std::fabs(y[2] - (std::exp(1.5) - std::exp(0.5)));
    };
    EXPECT_NEAR(std::log2(error(20) / error(80)) / 2, info.order, 0.2) << info.name;
  }
}

TEST(Evaluations, AreCountedAndAreWhatTheCatalogueSays) {
  for (const MethodInfo& info : method_catalogue()) {
    if (info.controlled) continue;
    const Oscillator system(1, 0.1);
    const auto method = make_method(info.name);
    State y{1, 0};
    advance(*method, system, y, 0, 0.1, 4);  // the longest history is of five steps
    const long started = method->evaluations();
    advance(*method, system, y, 0.4, 0.1, 10);
    EXPECT_EQ(method->evaluations() - started, 10 * (info.evaluations + (info.dense_jacobian ? 2 : 0))) << info.name;
    EXPECT_EQ(system.calls, method->evaluations()) << info.name;
  }
}

// The recurrence of the paper's scheme, written out for x' = v, v' = -w^2 x - 2 zeta w v.
struct Recurrence {
  double w, zeta, h;
  double x = 1, v = 0;
  bool started = false;
  double fx_before = 0, fv_before = 0;

  void step() {
    const auto acceleration = [this](double at, double speed) { return -w * w * at - 2 * zeta * w * speed; };
    const double fx = v;
    const double fv = acceleration(x, v);
    if (!started) {
      fx_before = fx;
      fv_before = fv;
      started = true;
    }
    const double px = x + h * (1.5 * fx - 0.5 * fx_before);
    const double pv = v + h * (1.5 * fv - 0.5 * fv_before);
    x += h / 2 * (pv + fx);
    v += h / 2 * (acceleration(px, pv) + fv);
    fx_before = fx;
    fv_before = fv;
  }
};

TEST(Pece, IsTheRecurrenceWrittenOut) {
  const Oscillator system(2, 0.1);
  const auto method = make_method("pece");
  State y{1, 0};
  Recurrence hand{2, 0.1, 0.05};
  for (int n = 0; n < 50; ++n) {
    method->step(system, n * 0.05, y, 0.05);
    hand.step();
    ASSERT_NEAR(y[0], hand.x, 1e-15 * (n + 1)) << n;  // one rounding a step, other order of operations
    ASSERT_NEAR(y[1], hand.v, 2e-15 * (n + 1)) << n;
  }
}

TEST(Pece, FirstStepIsHeun) {
  const auto method = make_method("pece");
  const Oscillator system(1, 0);
  State y{1, 0};
  method->step(system, 0, y, 0.5);
  EXPECT_EQ(y[0], 1 - 0.125);
  EXPECT_EQ(y[1], -0.5);
}

TEST(Pece, StartsAgainAfterARestart) {
  const auto used = make_method("pece");
  const Oscillator system(1, 0);
  State y{1, 0};
  advance(*used, system, y, 0, 0.1, 5);
  used->restart();
  State same = y;
  used->step(system, 0.5, y, 0.1);
  make_method("pece")->step(system, 0.5, same, 0.1);
  EXPECT_EQ(y, same);
}

// Steps of alternating lengths: the predictor's weights follow the ratio of the steps, so order 2 survives.
TEST(Pece, StaysOfSecondOrderWithUnequalSteps) {
  const auto error = [](int steps) {
    const Oscillator system(1, 0.1);
    const auto method = make_method("pece");
    State y{1, 0};
    double t = 0;
    for (int k = 0; k < steps; ++k) {
      const double h = (k % 2 == 0 ? 0.5 : 1.5) * 6 / steps;
      method->step(system, t, y, h);
      t += h;
    }
    return error_of(y, 1, 0.1, 6);
  };
  EXPECT_NEAR(std::log2(error(100) / error(400)) / 2, 2, 0.15);
}

TEST(Restart, LeavesNothingOfTheStepsBefore) {
  for (const MethodInfo& info : method_catalogue()) {
    const Oscillator one(3, 0.2);
    const Oscillator other(1, 0.1);
    Tolerances tolerances;
    tolerances.first_step = 0.1;
    const auto used = make_method(info.name, tolerances);
    State y{1, 0};
    advance(*used, one, y, 0, 0.1, 5);
    used->restart();
    State got{0.5, 0.25};
    State want = got;
    const double far = used->step(other, 0, got, 0.01);
    const double fresh = make_method(info.name, tolerances)->step(other, 0, want, 0.01);
    EXPECT_EQ(far, fresh) << info.name;
    EXPECT_EQ(got, want) << info.name;
  }
}

TEST(Restart, ForgetsAStateThatWasNotFinite) {
  for (const MethodInfo& info : method_catalogue()) {
    if (info.controlled) continue;
    const auto method = make_method(info.name);
    State y{std::nan(""), 0};
    method->step(Oscillator(1, 0), 0, y, 0.1);
    method->restart();
    y = {1, 0};
    method->step(Oscillator(1, 0), 0, y, 0.1);
    EXPECT_TRUE(std::isfinite(y[0])) << info.name;
  }
}

// Without damping: velocity Verlet is symmetric, so the way back is the way there with the velocity reversed.
TEST(Verlet, GoesBackTheWayItCameWithoutDamping) {
  const Oscillator system(1, 0);
  const auto method = make_method("verlet");
  State y{1, 0.25};
  advance(*method, system, y, 0, 0.3, 1000);
  EXPECT_GT(std::fabs(y[0] - 1), 1e-3);
  y[1] = -y[1];
  method->restart();
  advance(*method, system, y, 300, 0.3, 1000);
  EXPECT_NEAR(y[0], 1, 1e-12);  // 2000 roundings of 1e-16, at most added up
  EXPECT_NEAR(y[1], -0.25, 1e-12);
}

TEST(Verlet, KeepsItsOwnEnergyWithoutDamping) {
  const Oscillator system(1, 0);
  const auto method = make_method("verlet");
  State y{1, 0};
  const double h = 1;
  for (int n = 0; n < 1000; ++n) {
    method->step(system, n * h, y, h);
    EXPECT_NEAR(y[1] * y[1] + y[0] * y[0] * (1 - h * h / 4), 0.75, 1e-12);  // its conserved quantity
  }
}

// Growth of |y| a step on y' = z/h y, from the largest root of r^2 = r (1 + z + 3/4 z^2) - z^2/4.
double pece_growth(std::complex<double> z) {
  const std::complex<double> b = 1.0 + z + 0.75 * z * z;
  const std::complex<double> root = std::sqrt(b * b - z * z);
  return std::max(std::abs(b + root), std::abs(b - root)) / 2;
}

double size_after(const OdeSystem& system, State y, double h, int steps) {
  const auto method = make_method("pece");
  advance(*method, system, y, 0, h, steps);
  double sum = 0;
  for (const double v : y) sum += v * v;
  return std::sqrt(sum);
}

TEST(PeceStability, UndampedOscillatorGrowsOnlyAboveItsLimit) {
  EXPECT_LT(size_after(Oscillator(1, 0), {1, 0}, 0.99 * 1.287, 2000), 1e-3);
  EXPECT_GT(size_after(Oscillator(1, 0), {1, 0}, 1.01 * 1.287, 2000), 1e3);
}

TEST(PeceStability, RealAxisEndsAtTwo) {
  EXPECT_LT(size_after(Decay(), {0, 0, 1}, 1.98, 3000), 1e-3);
  EXPECT_GT(size_after(Decay(), {0, 0, 1}, 2.02, 3000), 1e3);
}

TEST(PeceStability, GrowthIsTheLargestRootOfItsPolynomial) {
  for (const double h : {0.3, 0.8, 1.2, 1.4}) {
    const double want = pece_growth({0, h});
    const double got =
        std::pow(size_after(Oscillator(1, 0), {1, 0}, h, 440) / size_after(Oscillator(1, 0), {1, 0}, h, 40), 1.0 / 400);
    EXPECT_NEAR(got, want, 2e-3) << h;  // |y| swings within a growth by a factor of 2 at most: 2^(1/400)
  }
}

TEST(PeceStability, DampsTheUndampedOscillatorByAQuarterOfTheFourthPower) {
  const double q = 0.1;
  const double want = std::pow(1 - q * q * q * q / 4, 10'000);
  EXPECT_NEAR(size_after(Oscillator(1, 0), {1, 0}, q, 10'000), want, 0.02 * want);  // next term: q^2 of the first one
}

// The jump evaluates all contacts at the state where the next step starts: a method that begins there takes that over.
TEST(Evaluations, OfAJumpAreTakenOverByTheStepBehindIt) {
  const std::set<std::string> not_yet{"pec", "verlet", "odeint_velocity_verlet"};  // see tests/expected_to_fail
  for (const MethodInfo& info : method_catalogue()) {
    if (info.controlled || info.conservative || info.dense_jacobian || not_yet.count(info.name) > 0) continue;
    EXPECT_EQ(evaluations_a_step(info.name), info.evaluations) << info.name;
  }
}

TEST(Catalogue, NamesAreUniqueAndCanBeMade) {
  std::set<std::string> names;
  for (const MethodInfo& info : method_catalogue()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(make_method(info.name)->info().name, info.name);
    EXPECT_FALSE(info.title.empty());
  }
  for (const char* name : {"pece", "pec", "pecece", "ab2", "symplectic_euler", "verlet", "rk4", "odeint_rk4",
                           "odeint_abm2", "odeint_dopri5"}) {
    EXPECT_EQ(names.count(name), 1u) << name;
  }
}

TEST(Catalogue, AnUnknownNameIsAnsweredWithWhereTheKnownOnesStand) {
  try {
    make_method("euler");
    FAIL() << "no method is called euler";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("'euler'"), std::string::npos);
    EXPECT_NE(text.find("see furrow methods"), std::string::npos);
  }
}

TEST(Catalogue, AMisspeltNameIsAnsweredWithTheNearestOne) {
  try {
    make_method("symplectic_eular");
    FAIL() << "no method is called so";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"symplectic_euler\"?"), std::string::npos);
  }
}

}  // namespace
}  // namespace furrow
