// Small systems on which the error of a method is known before it is run. Equations: time_stepping.cpp.
#pragma once

#include <cmath>

#include "methods/method.h"

namespace furrow::verification::time_stepping {

// z' = f(t, z) in three copies, and nothing else.
class Scalar : public OdeSystem {
 public:
  explicit Scalar(double (*f)(double t, double z)) : f_(f) {}
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 0; }
  void rhs(double t, const State& y, State& dydt) const override {
    for (std::size_t i = 0; i < 3; ++i) dydt[i] = f_(t, y[i]);
  }

 private:
  double (*f_)(double t, double z);
};

inline constexpr double rate = -1, stiff_rate = -2000;  // l, 1/s
inline const Scalar follows_sine([](double t, double z) { return rate * (z - std::sin(t)) + std::cos(t); });
inline const Scalar hurries_after_sine([](double t, double z) { return stiff_rate * (z - std::sin(t)) + std::cos(t); });
inline const Scalar exponential([](double t, double) { return std::exp(t); });
inline const Scalar growth([](double, double z) { return z; });
inline const Scalar parabola([](double t, double) { return 3 * t * t; });
inline const Scalar one([](double, double) { return 1.0; });
inline const Scalar three([](double, double) { return 3.0; });
inline const State zero(3, 0.0);
inline const Tolerances lax{.relative = 0, .absolute = 1e9, .first_step = 1e3};  // a controlled method takes any step

inline constexpr double end = 2;  // T
// Integrals over s in [0, T] of e^(l (T-s)) times phi'' = -sin s and phi''' = -cos s.
inline const double second = -(std::sin(end) - std::cos(end) + std::exp(-end)) / 2;
inline const double third = -(std::cos(end) + std::sin(end) - std::exp(-end)) / 2;

// Error at T of `pairs` of steps, the second one `ratio` times the first.
inline double error_after(Method& method, const OdeSystem& system, int pairs, double ratio) {
  const double h = end / pairs / (1 + ratio);
  State z = zero;
  for (int k = 0; k < pairs; ++k) {
    const double t = k * (1 + ratio) * h;
    method.step(system, t, z, h);
    method.step(system, t + h, z, ratio * h);
  }
  return z[0] - std::sin(end);
}

}  // namespace furrow::verification::time_stepping
