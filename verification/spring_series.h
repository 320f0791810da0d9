// The damped spring by Taylor series, the oracle of spring.h's closed forms, and the size of its derivatives, which the
// errors of methods go with.
#pragma once

#include <cmath>

#include "verification/spring.h"

namespace furrow::verification::single_spring {

inline constexpr double end = 1.0;  // s: ten radians

// The oracle's oracle: the same equation by Taylor series in steps so short that round-off is all that is left.
inline double series_position(double zeta, double t) {
  constexpr int steps = 200;
  long double x = 1;
  long double v = 0;
  const long double h = static_cast<long double>(t) / steps;
  for (int n = 0; n < steps; ++n) {
    long double a = x;  // k-th Taylor coefficients of x; x'' = -2 zeta omega x' - omega^2 x
    long double b = v;
    long double power = 1;
    long double new_x = 0;
    long double new_v = 0;
    for (int k = 0; k < 25; ++k) {
      new_x += a * power;
      new_v += b * power;
      const long double next = b / (k + 1);
      b = (-2 * static_cast<long double>(zeta) * omega * b - static_cast<long double>(omega) * omega * a) / (k + 1);
      a = next;
      power *= h;
    }
    x = new_x;
    v = new_v;
  }
  return static_cast<double>(x);
}

// Size of the n-th derivative of the exact solution at `end`, over omega^n x0: of it and the next one, so that it is no
// accident if one of them vanishes. From x'' = -2 zeta omega x' - omega^2 x.
inline double derivative(double zeta, int n) {
  double a = exact_position(zeta, end);
  double b = exact_velocity(zeta, end);
  for (int k = 0; k < n; ++k) {
    const double next = -2 * zeta * b - a;
    a = b;
    b = next;
  }
  return std::hypot(a, b);
}

}  // namespace furrow::verification::single_spring
