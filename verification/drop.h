// A disc dropped on a rigid floor, for the pages on bouncing: as in test DEM02 of MFiX's verification manual, with
// Hertz in place of its linear spring.
#pragma once

#include "verification/impact.h"

namespace furrow::verification {

inline constexpr double ball_radius = 0.1;  // m
inline constexpr double drop = 0.5;         // m, height of the centre
inline constexpr double g = 9.81;           // m/s^2

inline Matter of_modulus(double young) { return {"rubber", young, 0.3, 2600}; }

inline Scene drop_scene(double young) {
  Scene scene = wall_impact(of_modulus(young), ball_radius, 0, DiscMass::sphere, true);
  scene.model.gravity = g;
  scene.wall[0].point = {0, 0};
  scene.disc[0].position.y = drop;
  return scene;
}

}  // namespace furrow::verification
