// A disc on a floor that is in one piece or in several, for one_surface.cpp.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "verification/running.h"

namespace furrow::verification::one_surface {

inline constexpr double radius = 0.01;                                        // m
inline constexpr double density = 1000;                                       // kg/m^3
inline constexpr double young = 1e6;                                          // Pa
inline constexpr double poisson = 0.3;                                        // -
inline constexpr double gravity = 9.81;                                       // m/s^2
inline constexpr double modulus = young / (2 * (1 - poisson * poisson));      // Pa, E*
inline constexpr double mass = density * std::numbers::pi * radius * radius;  // kg
// m, of a disc that rests: (m g/(4/3 E* sqrt(R)))^(2/3)
inline const double resting = std::cbrt(std::pow(mass * gravity / (4.0 / 3 * modulus * std::sqrt(radius)), 2));

struct Floor {
  std::string name;
  Scene scene;
};

inline Plate slab(double left, double right, double lower) {
  return {.left_edge = left, .lower_edge = lower, .width = right - left, .height = -lower, .material = "any"};
}

// Surface at y = 0, a joint at x = 0.
inline Floor floor_of(const std::string& name, double friction) {
  Scene s;
  s.model = {.gravity = gravity, .moment_arm = MomentArm::radius, .tight_plates = true};
  s.contact.friction = friction;
  s.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  if (name == "one wall") s.wall.push_back({"floor", {0, 0}, {0, 1}, "any"});
  if (name == "two plates") s.plate = {slab(-0.25, 0, -0.0625), slab(0, 0.25, -0.0625)};
  if (name == "a high and a low plate") s.plate = {slab(-0.25, 0, -0.125), slab(0, 0.25, -0.0625)};
  if (name == "fixed nodes") {
    s.lattice.push_back({.origin = {-0.25, 0}, .columns = 9, .spacing = 0.0625, .material = "any"});
    s.lattice[0].fixed_rows = {0};
    s.lattice[0].auxiliary_points = 0;
  }
  return {name, s};
}

inline const std::vector<std::string> in_pieces{"two plates", "a high and a low plate", "fixed nodes"};

inline Ran on(Floor floor, double x, double speed, double spin, double end, const AfterStep& after = {}) {
  floor.scene.disc.push_back({{x, radius - resting}, radius, {speed, 0}, spin, "any"});
  return run_scene(floor.scene, "rk4", 1e-4, end, after);
}

}  // namespace furrow::verification::one_surface
