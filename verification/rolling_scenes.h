// A round body on a floor or a slope with rolling friction. Equations: rolling_resistance.cpp.
#pragma once

#include <cmath>

#include "verification/round_body.h"

namespace furrow::verification::rolling_resistance {

inline constexpr double radius = 0.01;   // m
inline constexpr double density = 1000;  // kg/m^3
inline constexpr double young = 1e8;     // Pa
inline constexpr double soft = 4e6;      // Pa
inline constexpr double poisson = 0.3;   // -
inline constexpr double gravity = 9.81;  // m/s^2
inline constexpr double rolling = 0.1;   // -, mu_r

inline double mass(const RoundBody& body) { return body.mass(density, radius); }  // kg

// m, of a disc that presses with `force` on a wall of its own material.
inline double overlap(double force, double modulus_of_young) {
  const double modulus = modulus_of_young / (2 * (1 - poisson * poisson));
  return std::cbrt(std::pow(force / (4.0 / 3 * modulus * std::sqrt(radius)), 2));
}

// On a floor that falls to the left.
inline Scene on_floor(const RoundBody& body, double friction, double e_modulus, double rise, double speed,
                      double spin) {
  Scene scene;
  const double level = std::sqrt(1 - rise * rise);
  scene.model = {.gravity = gravity, .disc_mass = body.reading, .moment_arm = MomentArm::radius};
  scene.contact = {.damping_factor = 1, .friction = friction, .rolling_friction = rolling};
  scene.material.push_back({.name = "any", .density = density, .young = e_modulus, .poisson = poisson});
  scene.wall.push_back({"floor", {0, 0}, {-rise, level}, "any"});
  const double height = radius - overlap(mass(body) * gravity * level, e_modulus);
  scene.disc.push_back({{-height * rise, height * level}, radius, {speed, 0}, spin, "any"});
  return scene;
}

inline double falling(double omega, double w0) {
  return std::sqrt(omega * omega + w0 * w0) - w0 * std::asinh(w0 / std::fabs(omega));
}

inline Scene with_spring(Scene scene) {
  scene.model.rolling = Rolling::spring;
  return scene;
}

}  // namespace furrow::verification::rolling_resistance
