// A disc above the nodes of a lattice, for the pages on their contact.
#pragma once

#include <cmath>
#include <numbers>

#include "scene/scene.h"

namespace furrow::verification::coupling {

inline constexpr double radius = 0.01;                                    // m
inline constexpr double density = 1000;                                   // kg/m^3
inline constexpr double young = 1e6;                                      // Pa
inline constexpr double poisson = 0.3;                                    // -
inline constexpr double node_mass = 0.5;                                  // kg
inline constexpr double spacing = 0.05;                                   // m
inline constexpr double closing = 0.2;                                    // m/s
inline constexpr double modulus = young / (2 * (1 - poisson * poisson));  // Pa, E*
inline const double hertz = 4.0 / 3 * modulus * std::sqrt(radius);        // N/m^(3/2), K; an edge has no curvature
inline constexpr double disc_mass = density * std::numbers::pi * radius * radius;  // kg

inline Scene disc_above(const Lattice& lattice, double x, double height) {
  Scene scene;
  scene.model.gravity = 0;
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  scene.lattice.push_back(lattice);
  scene.lattice[0].spacing = spacing;
  scene.lattice[0].node_mass = node_mass;
  scene.lattice[0].material = "any";
  scene.disc.push_back({{x, height}, radius, {0, -closing}, 0, "any"});
  return scene;
}

inline double reduced_mass(double softness) { return 1 / (1 / disc_mass + softness); }  // kg
inline double deepest(double reduced) {
  return std::pow(15 * reduced * closing * closing / (16 * modulus * std::sqrt(radius)), 0.4);
}

}  // namespace furrow::verification::coupling
