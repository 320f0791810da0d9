// Boost.Odeint in its adapters: the same as the own methods where it is the same scheme; its traps.
#include <gtest/gtest.h>

#include <cmath>

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

// The paper's scheme as Boost has it. Its first step is one of rk4, pece's is Heun's: they differ by h^3/6 x''' at once
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

// The force is given predicted velocities, so the damping does not cost the order, and the sums are those of verlet.
TEST(OdeintVelocityVerlet, IsTheOwnVerletToRoundOff) {
  const Oscillator system(2, 0.1);
  State own{1, 0};
  State odeint{1, 0};
  const auto one = make_method("verlet");
  const auto other = make_method("odeint_velocity_verlet");
  for (int n = 0; n < 100; ++n) {
    one->step(system, n * 0.05, own, 0.05);
    other->step(system, n * 0.05, odeint, 0.05);
    ASSERT_NEAR(own[0], odeint[0], 1e-15 * (n + 1));
    ASSERT_NEAR(own[1], odeint[1], 2e-15 * (n + 1));
  }
}

// Pendulums of frequencies 1, 2, 3, ... rad/s, and the integral of the first one's position.
struct Pendulums final : OdeSystem {
  explicit Pendulums(std::size_t number) : n(number) {}
  std::size_t size() const override { return 2 * n + 1; }
  std::size_t positions() const override { return n; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    for (std::size_t i = 0; i < n; ++i) {
      const double w = static_cast<double>(i + 1);
      dydt[i] = y[n + i];
      dydt[n + i] = -w * w * y[i];
    }
    dydt[2 * n] = y[0];
  }
  State start() const {
    State y(size(), 0.0);
    std::fill_n(y.begin(), n, 1.0);
    return y;
  }
  std::size_t n;
};

// The steppers' buffers never grow by themselves: a larger state ran over their ends.
TEST(Odeint, TakesSystemsOfAnySizeOneAfterTheOther) {
  for (const MethodInfo& info : method_catalogue()) {
    const auto used = make_method(info.name, tolerances_of(1e-3, 0.01));
    for (const std::size_t n : {1, 40, 3, 41}) {
      const Pendulums system(n);
      State got = system.start();
      State want = got;
      used->restart();
      const double h = used->step(system, 0, got, 0.01);
      const auto fresh = make_method(info.name, tolerances_of(1e-3, h));
      ASSERT_EQ(fresh->step(system, 0, want, h), h) << info.name;
      ASSERT_EQ(got, want) << info.name << " " << n;
    }
  }
}

// Half the way with h, half of it with h/2. With the history of the longer step kept, ab2, abm3 and higher would drop
// to order 1.
TEST(Odeint, ChangeOfStepKeepsTheOrder) {
  for (const MethodInfo& info : method_catalogue()) {
    if (info.controlled || info.family != "odeint") continue;
    const auto error = [&](int steps) {
      const Oscillator system(2, 0);
      const auto method = make_method(info.name);
      State y{1, 0};
      advance(*method, system, y, 0, 3.0 / steps, steps);
      advance(*method, system, y, 3, 1.5 / steps, 2 * steps);
      return std::hypot(2 * (y[0] - std::cos(12.0)), y[1] + 2 * std::sin(12.0));
    };
    EXPECT_NEAR(std::log2(error(100) / error(400)) / 2, info.order, 0.15) << info.name;
  }
}

// z' = -1e6 (z - cos t): five orders beyond the stable step of the explicit methods.
struct Stiff final : OdeSystem {
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  void rhs(double t, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = 0;
    dydt[2] = -1e6 * (y[2] - std::cos(t));
  }
};

TEST(OdeintImplicit, LongStepsOverAStiffDecay) {
  for (const char* name : {"odeint_implicit_euler", "odeint_rosenbrock4"}) {
    const auto method = make_method(name, tolerances_of(1e-3, 0.1));
    State y{0, 0, 1};
    double t = 0;
    while (t < 2) t += method->step(Stiff(), t, y, 0.1);
    EXPECT_NEAR(y[2], std::cos(t), 1e-3) << name;  // rosenbrock4's tolerance; of Euler's error 1e-6 is left
    EXPECT_LT(method->evaluations(), 1000) << name;
  }
}

// Newton's matrix h J - 1 is exactly zero in its third place: the stepper itself would end the program, with exit code
// 0.
struct Explosion final : OdeSystem {
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = dydt[1] = 0;
    dydt[2] = 4 * y[2];
  }
};

TEST(OdeintImplicit, ASingularMatrixIsADivergence) {
  State y{0, 0, 1};
  EXPECT_THROW(make_method("odeint_implicit_euler")->step(Explosion(), 0, y, 0.25), Divergence);
  EXPECT_EQ(y, (State{0, 0, 1}));
}

TEST(OdeintImplicit, RefusesLargeSystems) {
  for (const char* name : {"odeint_implicit_euler", "odeint_rosenbrock4"}) {
    const MethodInfo info = make_method(name)->info();
    EXPECT_EQ(refusal(info, Pendulums(99)), "");
    EXPECT_NE(refusal(info, Pendulums(100)).find("at most 200"), std::string::npos);
  }
}

TEST(OdeintSymplectic, RefusesForcesThatDependOnVelocity) {
  int refusing = 0;
  for (const MethodInfo& info : method_catalogue()) {
    EXPECT_EQ(refusal(info, Oscillator(1, 0)), "");
    if (refusal(info, Oscillator(1, 0.1)).find("the damper") != std::string::npos) ++refusing;
  }
  EXPECT_EQ(refusing, 3);
}

// Energy of the undamped oscillator swings, but has no trend: the greatest deviation of the last tenth of 10^4 steps is
// that of the first tenth. rk4 loses (h w)^6 / 72 a step, which adds up.
TEST(OdeintSymplectic, EnergyHasNoTrend) {
  const auto deviation = [](const std::string& name, bool late) {
    const auto method = make_method(name);
    State y{1, 0};
    double greatest = 0;
    for (int n = 0; n < 10'000; ++n) {
      method->step(Oscillator(1, 0), 0.5 * n, y, 0.5);
      if (late ? n >= 9000 : n < 1000) greatest = std::max(greatest, std::fabs(y[0] * y[0] + y[1] * y[1] - 1));
    }
    return greatest;
  };
  for (const MethodInfo& info : method_catalogue()) {
    if (!info.conservative) continue;
    EXPECT_NEAR(deviation(info.name, true), deviation(info.name, false), 0.02 * deviation(info.name, false));
  }
  EXPECT_GT(deviation("rk4", true), 4 * deviation("rk4", false));
}

}  // namespace
}  // namespace furrow
