// Two round bodies that meet head-on, and Hertz's closed form for them. Equations: hertz_pair.cpp.
#pragma once

#include "verification/impact.h"

namespace furrow::verification::hertz_pair {

inline constexpr double angle_x = 0.8;
inline constexpr double angle_y = 0.6;  // the line of centres leans

struct Body {
  Matter matter;
  double radius;  // m
  double speed;   // m/s, along the line of centres
};

struct Case {
  Body a, b;
  DiscMass reading;
};

inline double mass(const Body& body, DiscMass reading) { return mass_of(body.matter, body.radius, reading); }

inline Hertz closed_form(const Case& c) {
  const double m = 1 / (1 / mass(c.a, c.reading) + 1 / mass(c.b, c.reading));
  const double r = 1 / (1 / c.a.radius + 1 / c.b.radius);
  return {m, hertz_stiffness(softness(c.a.matter) + softness(c.b.matter), r), c.a.speed - c.b.speed};
}

// Body a touches body b from the lower left.
inline Scene scene_of(const Case& c) {
  Scene scene = impact_scene(c.reading);
  const double touch = c.a.radius + c.b.radius;
  add_disc(scene, c.a.matter, c.a.radius, {0, 0}, {angle_x * c.a.speed, angle_y * c.a.speed});
  add_disc(scene, c.b.matter, c.b.radius, {angle_x * touch, angle_y * touch},
           {angle_x * c.b.speed, angle_y * c.b.speed});
  return scene;
}

}  // namespace furrow::verification::hertz_pair
