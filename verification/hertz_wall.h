// A disc or sphere that meets a wall head-on, and Hertz's closed form for it. Equations: hertz_wall.cpp.
#pragma once

#include "verification/impact.h"

namespace furrow::verification::hertz_wall {

inline constexpr double radius = 0.1;  // m
inline constexpr double speed = 0.2;   // m/s
inline constexpr int steps = 200;      // in a contact time

inline Hertz closed_form(const Matter& m, DiscMass reading, bool rigid) {
  return {mass_of(m, radius, reading), hertz_stiffness((rigid ? 1 : 2) * softness(m), radius), speed};
}

// int_0^1 du / sqrt(1 - u^(5/2)), u = 1 - w^2, by Simpson's rule.
inline long double integral_of_contact() {
  constexpr int n = 20000;
  long double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const long double w = static_cast<long double>(k) / n;
    const long double rest = -std::expm1(2.5L * std::log1p(-w * w));
    const long double value = k == 0 ? 2 / std::sqrt(2.5L) : 2 * w / std::sqrt(rest);
    sum += value * (k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2);
  }
  return sum / (3 * n);
}

}  // namespace furrow::verification::hertz_wall
