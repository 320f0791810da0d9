// Springs and lattices that tear, for the pages on tears.
#pragma once

#include <numbers>
#include <utility>
#include <vector>

#include "verification/bare_lattice.h"
#include "verification/running.h"

namespace furrow::verification::tear {

inline constexpr double pi = std::numbers::pi;
inline constexpr double spacing = 0.1;               // m
inline constexpr double mass = 5;                    // kg
inline constexpr double stiffness = 500;             // N/m
inline constexpr double strength = 2;                // N
inline constexpr double omega = 10;                  // rad/s, sqrt(500 / 5)
inline constexpr double x_c = strength / stiffness;  // m

inline Scene lattice_scene(int rows, int columns) {
  Scene scene = bare_lattice(rows, columns, spacing, mass);
  scene.material.push_back({.name = "rigid", .rigid = true});
  scene.lattice[0].structural = {.stiffness = stiffness, .strength = strength};
  return scene;
}

// One spring from a fixed node to the free node 1.
inline Scene spring_scene(const NodeSetting& free) {
  Scene scene = lattice_scene(1, 2);
  scene.lattice[0].fixed_columns = {0};
  scene.lattice[0].node = {free};
  return scene;
}

struct Torn {
  Ran ran;
  std::vector<Tear> tears;
};

inline Torn run_and_tear(const Scene& scene, double step, double end) {
  std::vector<Tear> tears;
  Ran ran = run_scene(scene, "rk4", step, end, [&](double, const State&, const JumpReport& jump) {
    tears.insert(tears.end(), jump.torn.begin(), jump.torn.end());
    return true;
  });
  return {std::move(ran), std::move(tears)};
}

}  // namespace furrow::verification::tear
