// A lattice that is carried and turned as a whole, for the page on rigid motion.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "run/observe.h"
#include "verification/bare_lattice.h"
#include "verification/running.h"

namespace furrow::verification::rigid_motion {

inline constexpr double pi = std::numbers::pi;
inline constexpr double spacing = 0.1;     // m
inline constexpr double mass = 2;          // kg
inline constexpr double stiffness = 1000;  // N/m
inline constexpr double damping = 7;       // N s/m
inline constexpr double spin = 4;          // rad/s

inline Scene lattice_scene(int rows, int columns, Damper damper) {
  Scene scene = bare_lattice(rows, columns, spacing, mass);
  Lattice& lattice = scene.lattice[0];
  lattice.damper = damper;
  lattice.structural = {.stiffness = stiffness, .damping = damping};
  lattice.shear = {.stiffness = 2 * stiffness, .damping = 2 * damping};
  lattice.bending = {.stiffness = 3 * stiffness, .damping = 3 * damping};
  return scene;
}

// Turned by `angle` about the origin, where `rate` turns it on, and carried at (vx, vy).
inline State moved(const System& system, double angle, double rate, Vec2 velocity) {
  State y = system.initial_state();
  for (int n = 0; n < system.parts().node.count(); ++n) {
    const double x = system.parts().node.x[n];
    const double height = system.parts().node.y[n];
    const double px = std::cos(angle) * x - std::sin(angle) * height;
    const double py = std::sin(angle) * x + std::cos(angle) * height;
    y[system.x_of(n)] = px;
    y[system.y_of(n)] = py;
    y[system.vx_of(n)] = velocity.x - rate * py;
    y[system.vy_of(n)] = velocity.y + rate * px;
  }
  return y;
}

struct Sums {
  double greatest = 0, moment = 0;  // N, N m about the origin
};

inline Sums forces(const System& system, const State& y) {
  State rates(y.size());
  system.rhs(0, y, rates);
  Sums sums;
  for (int n = 0; n < system.parts().node.count(); ++n) {
    const double fx = mass * rates[system.vx_of(n)];
    const double fy = mass * rates[system.vy_of(n)];
    sums.greatest = std::max({sums.greatest, std::fabs(fx), std::fabs(fy)});
    sums.moment += y[system.x_of(n)] * fy - y[system.y_of(n)] * fx;
  }
  return sums;
}

struct Turning {
  double x, y, angular, energy;
};

// Two nodes that turn about their common centre for half a second, in the exact balance of spring and rotation.
inline Turning turn(Damper damper) {
  constexpr double reduced = mass / 2;  // kg
  constexpr double length = spacing / (1 - reduced * spin * spin / stiffness);
  Scene scene = lattice_scene(1, 2, damper);
  scene.lattice[0].origin = {-spacing / 2, 0};
  for (const int side : {0, 1}) {
    const double sign = side == 0 ? -1 : 1;
    scene.lattice[0].node.push_back({.column = side,
                                     .displacement = {sign * (length - spacing) / 2, 0},
                                     .velocity = {0, sign * spin * length / 2}});
  }
  const Ran ran = run_scene(scene, "rk4", 1e-3, 0.5);
  const Observation seen = observe(ran.system, 0.5, ran.y);
  return {(ran.y[ran.system.x_of(1)] - ran.y[ran.system.x_of(0)]) / length,
          (ran.y[ran.system.y_of(1)] - ran.y[ran.system.y_of(0)]) / length,
          seen.momentum.angular / (reduced * length * length * spin),
          seen.energy.stored() / (0.5 * reduced * length * length * spin * spin +
                                  0.5 * stiffness * (length - spacing) * (length - spacing))};
}

}  // namespace furrow::verification::rigid_motion
