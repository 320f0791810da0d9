// A block and round bodies on a slope, and how fast they gain speed and spin. Equations: incline.cpp.
#pragma once

#include <cmath>

#include "verification/round_body.h"
#include "verification/running.h"

namespace furrow::verification::incline {

inline constexpr double radius = 0.01;                                                // m; R* of the block
inline constexpr double density = 1000;                                               // kg/m^3
inline constexpr double young = 1e9;                                                  // Pa
inline constexpr double poisson = 0.3;                                                // -
inline constexpr double gravity = 9.81;                                               // m/s^2
inline constexpr double rise = 0.28;                                                  // sin theta
inline constexpr double level = 0.96;                                                 // cos theta
inline constexpr double node_mass = 0.5;                                              // kg
inline constexpr double modulus = young / (2 * (1 - poisson * poisson));              // Pa, E*
inline constexpr double shear_modulus = young / (4 * (1 + poisson) * (2 - poisson));  // Pa, G*

inline double overlap(double mass) {
  return std::cbrt(std::pow(mass * gravity * level / (4.0 / 3 * modulus * std::sqrt(radius)), 2));
}

inline Scene slope(double friction, double rolling, double damping) {
  Scene scene;
  scene.model = {.gravity = gravity, .moment_arm = MomentArm::radius, .rolling_smoothing = 1e-3};
  scene.contact = {.damping_factor = damping, .friction = friction, .rolling_friction = rolling};
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  scene.wall.push_back({"slope", {0, 0}, {-rise, level}, "any"});  // falls to the left
  return scene;
}

inline Scene block(double friction) {
  Scene scene = slope(friction, 0, 1);
  const double d = overlap(node_mass);
  Lattice node{.origin = {d * rise, -d * level}, .node_mass = node_mass, .material = "any", .gravity = true};
  node.contact_radius = radius;
  scene.lattice.push_back(node);
  return scene;
}

// Rolling down with `speed`.
inline Scene wheel(const RoundBody& body, double friction, double rolling, double speed) {
  Scene scene = slope(friction, rolling, 0.5);
  scene.model.disc_mass = body.reading;
  const double height = radius - overlap(body.mass(density, radius));
  scene.disc.push_back(
      {{-height * rise, height * level}, radius, {-speed * level, -speed * rise}, speed / radius, "any"});
  return scene;
}

struct Rates {
  double acceleration;  // m/s^2, downhill
  double turning;       // rad/s^2
  double speed;         // m/s, at the end
};

// Between 0.05 s, when what rang has died, and 0.1 s.
inline Rates rates_of(const Scene& scene) {
  const System system(scene);
  double speed[2] = {};
  double spin[2] = {};
  run_scene(scene, "rk4", 2e-5, 0.1, [&](double t, const State& y, const JumpReport&) {
    const int k = t < 0.05 - 1e-9 ? 0 : 1;
    const double downhill = -(y[system.vx_of(0)] * level + y[system.vy_of(0)] * rise);
    const double turns = scene.disc.empty() ? 0 : y[system.spin_of(0)];
    if (k == 0 || std::fabs(t - 0.05) < 1e-9) {
      speed[0] = downhill;
      spin[0] = turns;
    }
    speed[1] = downhill;
    spin[1] = turns;
    return true;
  });
  return {(speed[1] - speed[0]) / 0.05, (spin[1] - spin[0]) / 0.05, speed[1]};
}

}  // namespace furrow::verification::incline
