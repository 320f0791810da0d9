// What a method makes of an undamped spring, step by step: in closed form and by its recurrence. Equations:
// free_spring.cpp.
#pragma once

#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "verification/spring.h"

namespace furrow::verification::free_spring {

using Complex = std::complex<long double>;
inline constexpr double pi = 3.14159265358979323846;
inline constexpr int steps = 1000;

// y_n over x0, exactly as the method computes it but for round-off.
inline Complex discrete_solution(const std::string& method, double q, int n) {
  const Complex z(0, -q);
  if (method == "verlet") {
    const long double theta = 2 * std::asin(0.5L * q);  // 1 - cos(theta) = q^2/2
    return {std::cos(n * theta), -std::sqrt(1 - 0.25L * q * q) * std::sin(n * theta)};
  }
  if (method == "rk4") return std::pow(1.0L + z * (1.0L + z / 2.0L * (1.0L + z / 3.0L * (1.0L + z / 4.0L))), n);
  const Complex b = 1.0L + z + 0.75L * z * z;
  const Complex root = std::sqrt(b * b - z * z);
  const Complex r1 = (b + root) / 2.0L;
  const Complex r2 = (b - root) / 2.0L;
  const Complex share = (1.0L + z + z * z / 2.0L - r2) / (r1 - r2);
  return share * std::pow(r1, n) + (1.0L - share) * std::pow(r2, n);
}

// The same, step by step; for pece with its predictor and corrector written out.
inline Complex recurrence(const std::string& method, double q, int n) {
  const Complex z(0, -q);
  Complex before = 1;
  Complex now = 1;
  for (int k = 0; k < n; ++k) {
    if (method == "verlet") {
      const long double x = now.real() + q * (now.imag() - 0.5L * q * now.real());
      now = {x, now.imag() - 0.5L * q * (now.real() + x)};
    } else if (method == "rk4") {
      now += z * now + z * z * now / 2.0L + z * z * z * now / 6.0L + z * z * z * z * now / 24.0L;
    } else {
      const Complex predicted = now + z * (1.5L * now - 0.5L * before);
      before = now;
      now += 0.5L * z * (predicted + now);
    }
  }
  return now;
}

// Mean period over `count` swings, s: upward crossings of x = 0, each from the cubic through both ends of its step.
inline double measured_period(const std::string& method, double step, int count) {
  std::vector<double> crossings;
  double x0 = 1, v0 = 0, t0 = 0;
  run_scene(spring_scene(0), method, step, (count + 1) * 2 * pi / omega,
            [&](double t, const State& y, const JumpReport&) {
              const double x = position(y);
              const double v = velocity(y);
              if (x0 < 0 && x >= 0) {
                const double q = omega * (t - t0);
                double s = x0 / (x0 - x);
                for (int k = 0; k < 5; ++k) {
                  const double value = x0 * (1 + 2 * s) * (1 - s) * (1 - s) + x * s * s * (3 - 2 * s) +
                                       q * s * (1 - s) * (v0 * (1 - s) - v * s);
                  s -= value / (q * (v0 + v) / 2);
                }
                crossings.push_back(t0 + s * (t - t0));
              }
              x0 = x;
              v0 = v;
              t0 = t;
              return true;
            });
  return (crossings.at(static_cast<std::size_t>(count)) - crossings.front()) / count;
}

}  // namespace furrow::verification::free_spring
