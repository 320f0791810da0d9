// Tiny systems with a solution in closed form, for the tests of the methods.
#pragma once

#include <cmath>

#include "methods/method.h"

namespace furrow::test {

// x' = v, v' = -w^2 x - 2 zeta w v
struct Oscillator final : OdeSystem {
  Oscillator(double w, double zeta) : frequency(w), ratio(zeta) {}
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  std::string velocity_dependence() const override { return ratio > 0 ? "the damper" : ""; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    ++calls;
    dydt[0] = y[1];
    dydt[1] = -frequency * frequency * y[0] - 2 * ratio * frequency * y[1];
  }
  double frequency, ratio;  // rad/s, -
  mutable long calls = 0;
};

// z' = e^t, and a position that rests
struct Clock final : OdeSystem {
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  void rhs(double t, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = 0;
    dydt[2] = std::exp(t);
  }
};

// z' = -z, and a position that rests
struct Decay final : OdeSystem {
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = 0;
    dydt[2] = -y[2];
  }
};

// An oscillator that counts in the error control, and a third number z' = rate(t) that does not.
template <class Rate>
struct Beside final : OdeSystem {
  explicit Beside(Rate third) : rate(third) {}
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  std::size_t controlled() const override { return 2; }
  void rhs(double t, const State& y, State& dydt) const override {
    dydt[0] = y[1];
    dydt[1] = -y[0];
    dydt[2] = rate(t);
  }
  Rate rate;
};

// Cannot be computed beyond x = `edge`: long trial steps end there, the solution from x = 0, v = 1 does not: 1 - e^-t,
// or sin t if it `swings`.
struct Cliff final : OdeSystem {
  Cliff(double beyond, bool oscillator) : edge(beyond), swings(oscillator) {}
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {
    if (y[0] > edge) {
      ++falls;
      throw Divergence("beyond the cliff");
    }
    dydt[0] = y[1];
    dydt[1] = swings ? -y[0] : -y[1];
  }
  double edge;
  bool swings;
  mutable int falls = 0;
};

inline Tolerances tolerances_of(double relative, double first_step = 1e-4) {
  Tolerances t;
  t.relative = relative;
  t.absolute = relative;
  t.first_step = first_step;
  return t;
}

inline void advance(Method& method, const OdeSystem& system, State& y, double t, double h, int steps) {
  for (int k = 0; k < steps; ++k) method.step(system, t + k * h, y, h);
}

}  // namespace furrow::test
