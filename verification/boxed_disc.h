// A disc pressed by walls at the sides asked for, and what its stress should be. Equations: particle_stress.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "run/observe.h"
#include "verification/impact.h"

namespace furrow::verification::particle_stress {

inline constexpr double radius = 0.02;   // m
inline constexpr double overlap = 1e-3;  // m
inline constexpr double friction = 0.4;
inline constexpr Matter soil{"soil", 2e5, 0.25, 1000};
inline constexpr double pi = 3.14159265358979323846;

// Walls, rigid, at the sides asked for; normals point to the disc at the origin.
enum Side { left, right, below, above };
inline constexpr std::array<Vec2, 4> inwards{Vec2{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

inline Scene boxed(const std::vector<Side>& sides, DiscMass reading = DiscMass::disc) {
  Scene scene = impact_scene(reading);
  add_disc(scene, soil, radius, {0, 0}, {0, 0});
  scene.material.push_back({.name = "rigid", .rigid = true});
  for (const Side side : sides) {
    const Vec2 n = inwards[side];
    const double at = radius - overlap;
    scene.wall.push_back({.point = {-at * n.x, -at * n.y}, .normal = n, .material = "rigid"});
  }
  return scene;
}

inline const double force = hertz_stiffness(softness(soil), radius) * std::pow(overlap, 1.5);  // N
inline constexpr double arm = radius - overlap;                                                // m
inline constexpr double disc_volume = pi * radius * radius;                                    // m^3, 1 m deep

inline Stress stress_of(const Scene& scene) {
  const System system(scene);
  return disc_stresses(system, 0, system.initial_state())[0];
}

// Pa; want over `scale`, which is 2 b F / V where nothing else is said.
inline void expect_stress(const std::string& what, const Stress& got, double xx, double yy, double xy) {
  const double scale = std::max({std::fabs(xx), std::fabs(yy), std::fabs(xy)});
  const auto round_off = absolute(1e-14 * scale, "round-off: R - 0.95 R costs a digit of the overlap, then products");
  expect(what + ": sxx [Pa]", got(0, 0), xx, round_off);
  expect(what + ": syy [Pa]", got(1, 1), yy, round_off);
  expect(what + ": sxy [Pa]", got(0, 1), xy, round_off);
  expect(what + ": syx [Pa]", got(1, 0), xy, round_off);
  expect(what + ": von Mises [Pa]", von_mises(got), std::sqrt(xx * xx - xx * yy + yy * yy + 3 * xy * xy), round_off);
}

}  // namespace furrow::verification::particle_stress
