// Discs that stick where they touch, for the pages on Mindlin's spring. Equations: sticking_impact.cpp.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "verification/round_body.h"
#include "verification/running.h"

namespace furrow::verification::sticking_impact {

inline constexpr double radius = 0.01;    // m
inline constexpr double density = 1000;   // kg/m^3
inline constexpr double young = 2e5;      // Pa
inline constexpr double closing = 0.1;    // m/s
inline constexpr double sideways = 0.05;  // m/s, vx
inline constexpr double spin = 3;         // rad/s
inline constexpr double slip = sideways + spin * radius;

inline double mass(const RoundBody& body) { return body.mass(density, radius); }  // kg

inline double restitution(double ratio, double c) {
  return std::cos(std::numbers::pi * std::sqrt(0.01 + 4.8 * ratio * (1 + 1 / c))) / std::cos(std::numbers::pi / 10);
}
inline double shear_ratio(double nu) { return (1 - nu) / (2 * (2 - nu)); }

// s: Hertz's contact time, 2.943275 d_max / v with d_max = (5 m v^2 / (4 K))^(2/5).
inline double contact_time(double mass, double reduced_radius, double modulus, double v) {
  return 2.943275184324047 * std::pow(15 * mass * v * v / (16 * modulus * std::sqrt(reduced_radius)), 0.4) / v;
}

inline Scene impact(const RoundBody& body, double nu, double height) {
  Scene scene;
  scene.model = {.gravity = 0, .disc_mass = body.reading, .moment_arm = MomentArm::radius};
  scene.contact.friction = 1e12;
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = nu});
  scene.disc.push_back({{0, height}, radius, {sideways, -closing}, spin, "any"});
  scene.wall.push_back({"floor", {0, 0}, {0, 1}, "any"});
  return scene;
}

// From an overlap of 1e-13 R, so that the spring follows the slip from the first stage of the first step. The contact
// opens at 0.7 of a step: on a step's end or middle the ledger would meet 1/sqrt(d) at d = 0. `gap` in steps.
inline Ran run_impact(const RoundBody& body, double nu, int steps, double gap = 0) {
  const double time = contact_time(mass(body), radius, young / (2 * (1 - nu * nu)), closing);
  const double step = time / (steps + 0.7);
  const double height = gap > 0 ? radius + gap * closing * step : radius * (1 - 1e-13);
  return run_scene(impact(body, nu, height), "rk4", step, 1.05 * time);
}

inline std::string which(const RoundBody& body, double nu) {
  return ", " + body.name + ", nu " + std::to_string(nu).substr(0, 5);
}

// Two discs that are almost rigid, closing along x, the second one at rest: the line of centres must not turn.
struct TwoDiscs {
  static constexpr double nu = 0.3;
  static constexpr double young = 2e17;  // Pa
  static constexpr double other = 0.02;  // m, the second radius
  double mass2 = mass(disc) * 4;
  double reduced = mass(disc) * mass2 / (mass(disc) + mass2);
  double reduced_radius = radius * other / (radius + other);
  double time = contact_time(reduced, reduced_radius, young / (2 * (1 - nu * nu)), closing);
  double turn = closing * time / (radius + other);      // rad, at most, if the slip is not faster than the approach
  double start = sideways + spin * radius - 1 * other;  // m/s, slip

  // `gap` in steps.
  Ran run(int steps, double gap) const {
    const double step = time / (steps + 0.7);
    const double distance = gap > 0 ? radius + other + gap * closing * step : (radius + other) * (1 - 1e-15);
    Scene scene = impact(disc, nu, 0);
    scene.material[0].young = young;
    scene.wall.clear();
    scene.disc = {{{0, 0}, radius, {closing, sideways}, spin, "any"}, {{distance, 0}, other, {0, 0}, -1, "any"}};
    return run_scene(scene, "rk4", step, 1.05 * time);
  }
};

}  // namespace furrow::verification::sticking_impact
