// The mass on a spring that several pages share: scene and closed forms.
//
//   m x'' + c x' + k x = 0,  x(0) = x0, x'(0) = 0
//   omega = sqrt(k/m),  zeta = c / (2 sqrt(k m))
//   zeta < 1:  x = x0 e^(-zeta omega t) (cos(wd t) + zeta omega/wd sin(wd t)),  wd = omega sqrt(1 - zeta^2)
//   zeta = 1:  x = x0 e^(-omega t) (1 + omega t)
//   zeta > 1:  x = x0 (r2 e^(r1 t) - r1 e^(r2 t)) / (r2 - r1),  r = -zeta omega +- omega sqrt(zeta^2 - 1)
#pragma once

#include <cmath>
#include <string>

#include "verification/bare_lattice.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {

inline constexpr double mass = 5;         // kg
inline constexpr double stiffness = 500;  // N/m
inline constexpr double stretch = 0.01;   // m, x0
inline constexpr double omega = 10;       // rad/s, sqrt(500 / 5)
inline constexpr double rest = 0.1;       // m, length of the spring

// Over x0. A closed form for each regime; nothing of the solver is called.
inline double exact_position(double zeta, double t) {
  if (zeta == 1) return std::exp(-omega * t) * (1 + omega * t);
  if (zeta < 1) {
    const double wd = omega * std::sqrt(1 - zeta * zeta);
    return std::exp(-zeta * omega * t) * (std::cos(wd * t) + zeta * omega / wd * std::sin(wd * t));
  }
  const double root = omega * std::sqrt(zeta * zeta - 1);
  const double r1 = -zeta * omega + root;
  const double r2 = -zeta * omega - root;
  return (r2 * std::exp(r1 * t) - r1 * std::exp(r2 * t)) / (r2 - r1);
}

// Over omega x0: in every regime x' = -omega^2 x0 times the response to a unit velocity.
inline double exact_velocity(double zeta, double t) {
  if (zeta == 1) return -std::exp(-omega * t) * omega * t;
  const double turn = omega * std::sqrt(std::fabs(1 - zeta * zeta));
  return -std::exp(-zeta * omega * t) * omega / turn * (zeta < 1 ? std::sin(turn * t) : std::sinh(turn * t));
}

inline Scene spring_scene(double zeta) {
  Scene scene = bare_lattice(1, 2, rest, mass);
  Lattice& spring = scene.lattice[0];
  spring.fixed_columns = {0};
  spring.structural = {.stiffness = stiffness, .damping = 2 * zeta * std::sqrt(stiffness * mass)};
  spring.node.push_back({.row = 0, .column = 1, .displacement = {stretch, 0}});
  return scene;
}

// Of the one free node: state [x, y, vx, vy].
inline double position(const State& y) { return (y[0] - rest) / stretch; }
inline double velocity(const State& y) { return y[2] / (omega * stretch); }

}  // namespace furrow::verification
