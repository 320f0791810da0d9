// Damped spheres against a wall, in units of the impact, for the pages on damped impact.
#pragma once

#include <cmath>

#include "verification/damped_hertz.h"
#include "verification/impact.h"

namespace furrow::verification::damped_impact {

inline constexpr double radius = 0.0025;  // m
inline constexpr double pi = 3.14159265358979323846;
inline constexpr double tolerance = 1e-12;  // of the controlled method, in units of the impact
inline constexpr int steps = 1000;          // in a contact time, at least

// A controlled method: the force starts as t^(1/4), where fixed steps are of order 5/4 only.
inline Tolerance controlled(double errors) {
  return relative(errors * tolerance, "error control: so many errors of 1e-12 add up, measured once, doubled");
}

struct Units {
  double mass, stiffness;  // kg, N/m^(3/2)
  double speed;            // m/s
  double length() const { return std::pow(mass * speed * speed / stiffness, 0.4); }
  double time() const { return length() / speed; }
};

inline Units units_of(const Matter& m, double speed) {
  return {mass_of(m, radius, DiscMass::sphere), hertz_stiffness(softness(m), radius), speed};
}

inline Scene scene_of(const Matter& m, double speed) {
  Scene scene = wall_impact(m, radius, speed, DiscMass::sphere, true);
  scene.model.pull = true;
  return scene;
}

inline double beta_of(double e) { return -std::log(e) / std::hypot(std::log(e), pi); }

}  // namespace furrow::verification::damped_impact
