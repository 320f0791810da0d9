// The solver's forces on a lattice whose nodes are displaced, for the pages on its waves and its elastic constants.
#pragma once

#include <Eigen/Dense>
#include <numbers>
#include <vector>

#include "run/system.h"
#include "verification/bare_lattice.h"

namespace furrow::verification::lattice_waves {

using Eigen::Matrix2d;
using Eigen::Vector2d;

inline constexpr double pi = std::numbers::pi;
inline constexpr double spacing = 0.1;  // m
inline constexpr double mass = 3;       // kg
inline constexpr double ks = 1000;      // N/m
inline constexpr double kd = 300;       // N/m
inline constexpr double kb = 170;       // N/m
inline constexpr int side = 7;          // nodes
inline constexpr int middle = 3;        // its two neighbours on each side are there

inline System lattice_system(int rows, int columns, double structural, double shear) {
  Scene scene = bare_lattice(rows, columns, spacing, mass);
  scene.lattice[0].structural.stiffness = structural;
  scene.lattice[0].shear.stiffness = shear;
  scene.lattice[0].bending.stiffness = kb;
  return System(scene);
}

// Force on each node of the lattice for displacements u(row, column).
template <class Displacement>
std::vector<Vector2d> forces(const System& system, const Displacement& u) {
  State y = system.initial_state();
  const NodeArrays& node = system.parts().node;
  for (int n = 0; n < node.count(); ++n) {
    const Vector2d moved = u(node.row[n], node.column[n]);
    y[system.x_of(n)] += moved.x();
    y[system.y_of(n)] += moved.y();
  }
  State rates(y.size());
  system.rhs(0, y, rates);
  std::vector<Vector2d> force;
  for (int n = 0; n < node.count(); ++n)
    force.emplace_back(mass * rates[system.vx_of(n)], mass * rates[system.vy_of(n)]);
  return force;
}

// Half the difference of the forces for u and -u: free of terms of second order.
template <class Displacement>
std::vector<Vector2d> odd_forces(const System& system, const Displacement& u) {
  std::vector<Vector2d> force = forces(system, u);
  const std::vector<Vector2d> back = forces(system, [&](int row, int column) -> Vector2d { return -u(row, column); });
  for (std::size_t n = 0; n < force.size(); ++n) force[n] = 0.5 * (force[n] - back[n]);
  return force;
}

}  // namespace furrow::verification::lattice_waves
