// A chain of masses along x, for the pages on its waves.
#pragma once

#include <numbers>

#include "verification/bare_lattice.h"

namespace furrow::verification::chain_modes {

inline constexpr double pi = std::numbers::pi;
inline constexpr double spacing = 0.1;       // m
inline constexpr double mass = 2;            // kg
inline constexpr double stiffness = 800;     // N/m
inline constexpr double skip = 300;          // N/m, skip-one springs
inline constexpr double amplitude = 0.02;    // m
inline constexpr int masses = 8;             // free ones
inline constexpr double step_in_rad = 0.01;  // omega h

inline Scene chain_scene(int columns) {
  Scene scene = bare_lattice(1, columns, spacing, mass);
  scene.lattice[0].structural.stiffness = stiffness;
  return scene;
}

}  // namespace furrow::verification::chain_modes
