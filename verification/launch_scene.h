// A disc or sphere set down sliding on a floor. Equations: slide_to_roll.cpp.
#pragma once

#include <cmath>
#include <string>

#include "verification/round_body.h"

namespace furrow::verification::slide_to_roll {

inline constexpr double radius = 0.01;     // m
inline constexpr double density = 1000;    // kg/m^3
inline constexpr double poisson = 0.3;     // -
inline constexpr double gravity = 9.81;    // m/s^2
inline constexpr double launch = 0.1;      // m/s, u0
inline constexpr double young_hard = 1e9;  // Pa
inline constexpr double young_soft = 4e6;  // Pa: a disc sinks in by 5 % of its radius

inline double mass(const RoundBody& body) { return body.mass(density, radius); }  // kg

// m: under its own weight, on a wall of the same material.
inline double resting_overlap(const RoundBody& body, double young) {
  const double modulus = young / (2 * (1 - poisson * poisson));
  return std::cbrt(std::pow(mass(body) * gravity / (4.0 / 3 * modulus * std::sqrt(radius)), 2));
}

inline Scene launch_scene(const RoundBody& body, double friction, double young, MomentArm moment_arm) {
  Scene scene;
  scene.model = {.gravity = gravity, .disc_mass = body.reading, .moment_arm = moment_arm};
  scene.contact = {.damping_factor = 0.5, .friction = friction};
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  scene.wall.push_back({"floor", {0, 0}, {0, 1}, "any"});
  scene.disc.push_back({{0, radius - resting_overlap(body, young)}, radius, {launch, 0}, 0, "any"});
  return scene;
}

inline std::string which(const RoundBody& body, double friction) {
  return ", " + body.name + ", mu " + std::to_string(friction).substr(0, 3);
}

}  // namespace furrow::verification::slide_to_roll
