// Bodies that are pressed into a plate that stands still, for the pages on kept faces; and, written a second time, the
// potential in which they move.
//
//   U = 8/15 E* sqrt(R) (R + D)^(5/2),   D = -(distance) in front of the corner, min*(a, b) behind both of its faces
//
// a and b are the depths behind the left and the lower face; the formula of min* stands in kept_face_corner.cpp.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "verification/running.h"

namespace furrow::verification::kept_face {

inline constexpr double radius = 0.01;                                    // m
inline constexpr double density = 1000;                                   // kg/m^3
inline constexpr double young = 1e6;                                      // Pa
inline constexpr double poisson = 0.3;                                    // -
inline constexpr double width = 0.01;                                     // m, of the plate, whose corner is at 0, 0
inline constexpr double modulus = young / (2 * (1 - poisson * poisson));  // Pa, E*
inline constexpr double mass = density * std::numbers::pi * radius * radius;  // kg, of the disc
inline const double hertz = 8.0 / 15 * modulus * std::sqrt(radius);           // J/m^(5/2), of U

inline Scene plate_scene() {
  Scene scene;
  scene.model.gravity = 0;
  scene.model.tight_plates = true;
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  scene.plate.push_back({.lower_edge = 0, .width = width, .height = 0.1, .material = "any"});
  return scene;
}

inline Scene thrown_disc(Vec2 position, Vec2 velocity) {
  Scene scene = plate_scene();
  scene.disc.push_back({position, radius, velocity, 0, "any"});
  return scene;
}

inline long double rounded_least(long double one, long double other) {
  const long double low = std::fmin(one, other), high = std::fmax(one, other);
  if (2 * low <= high) return low;
  const long double above_half = low / high - 0.5L;
  return low - high * above_half * above_half / 1.75L;
}

inline long double depth(long double x, long double y) {
  if (x >= 0 && y >= 0) return rounded_least(x, y);
  return -std::hypot(std::fmin(x, 0.0L), std::fmin(y, 0.0L));
}

inline long double potential(long double x, long double y) {  // J
  const long double overlap = radius + depth(x, y);
  return overlap > 0 ? hertz * overlap * overlap * std::sqrt(overlap) : 0;
}

using Motion = std::array<long double, 4>;  // x, y, vx, vy

inline Motion rates_of(const Motion& s) {
  constexpr long double h = 1e-7L;
  const long double fx = (potential(s[0] - h, s[1]) - potential(s[0] + h, s[1])) / (2 * h);
  const long double fy = (potential(s[0], s[1] - h) - potential(s[0], s[1] + h)) / (2 * h);
  return {s[2], s[3], fx / mass, fy / mass};
}

inline Motion integrated(Motion s, double end, int steps) {
  const long double h = end / steps;
  const auto shifted = [](const Motion& from, long double by, const Motion& along) {
    Motion to = from;
    for (std::size_t i = 0; i < 4; ++i) to[i] += by * along[i];
    return to;
  };
  for (int k = 0; k < steps; ++k) {
    const Motion a = rates_of(s), b = rates_of(shifted(s, h / 2, a)), c = rates_of(shifted(s, h / 2, b)),
                 d = rates_of(shifted(s, h, c));
    for (std::size_t i = 0; i < 4; ++i) s[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  return s;
}

}  // namespace furrow::verification::kept_face
