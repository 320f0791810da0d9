// Impacts by the linear law, for the pages on it.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "verification/impact.h"
#include "verification/round_body.h"

namespace furrow::verification::linear {

inline constexpr double radius = 0.1;       // m
inline constexpr double density = 2600;     // kg/m^3
inline constexpr double stiffness = 5e4;    // N/m, kn
inline constexpr double speed = 2;          // m/s
inline constexpr double tolerance = 1e-12;  // of the controlled method, in units of the impact
inline constexpr int steps = 1000;          // in a contact time, at least

inline double mass(const RoundBody& body) { return body.mass(density, radius); }          // kg
inline double omega(const RoundBody& body) { return std::sqrt(stiffness / mass(body)); }  // rad/s
inline double beta_of(double e) { return -std::log(e) / std::hypot(std::log(e), std::numbers::pi); }

// A body that touches the floor at this moment.
inline Scene impact(const RoundBody& body) {
  Scene scene;
  scene.model = {.gravity = 0, .disc_mass = body.reading, .moment_arm = MomentArm::radius, .law = ForceLaw::linear};
  scene.contact.normal_stiffness = stiffness;
  scene.material.push_back({.name = "any", .density = density, .rigid = true});
  scene.disc.push_back({{0, -1e-15 * radius}, radius, {0, -speed}, 0, "any"});  // touching from the first stage on
  scene.wall.push_back({"floor", {0, -radius}, {0, 1}, "any"});
  return scene;
}

inline Tolerance controlled(double errors) {
  return relative(errors * tolerance, "error control: so many errors of 1e-12 add up, measured once, doubled");
}

// With rk4, for what happens within the contact; it opens at 0.7 of a step.
inline Impact by_steps(const Scene& scene, const RoundBody& body, double contact_time) {
  return measure(scene, mass(body), {"rk4", contact_time / 20000.7, 1.1 * contact_time});
}

// Speed of separation over speed of approach, deepest overlap and contact time.
inline Impact measured(const Scene& scene, const RoundBody& body, double contact_time) {
  return measure(scene, mass(body),
                 {"odeint_dopri5", contact_time / steps, 1.1 * contact_time, tolerance, speed / omega(body)});
}

}  // namespace furrow::verification::linear
