// A block and a disc on a slope: what sticks, what slides and what rolls.
//
//   block (a node):  mu > tan theta: it stays, after the spring has stretched by m g sin theta / St;
//                    else  a = g (sin theta - mu cos theta)
//   disc:            mu > tan theta c / (1 + c): it rolls, a = g sin theta / (1 + c), and with rolling friction
//                    a = g (sin theta - mu_r cos theta) / (1 + c);  else it slides, a = g (sin theta - mu cos theta),
//                    omega' = mu g cos theta / (c R)
// St = 8 G* sqrt(R* d), d = (m g cos theta / K)^(2/3), K = 4/3 E* sqrt(R*). Arms are radii here.
//
// Source: any textbook of mechanics; with rolling friction LAMMPS, granular tests, incline_rolling.
#include <cmath>
#include <numbers>
#include <string>

#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

constexpr double radius = 0.01;                                                // m; R* of the block
constexpr double density = 1000;                                               // kg/m^3
constexpr double young = 1e9;                                                  // Pa
constexpr double poisson = 0.3;                                                // -
constexpr double gravity = 9.81;                                               // m/s^2
constexpr double rise = 0.28;                                                  // sin theta
constexpr double level = 0.96;                                                 // cos theta
constexpr double node_mass = 0.5;                                              // kg
constexpr double modulus = young / (2 * (1 - poisson * poisson));              // Pa, E*
constexpr double shear_modulus = young / (4 * (1 + poisson) * (2 - poisson));  // Pa, G*

double overlap(double mass) {
  return std::cbrt(std::pow(mass * gravity * level / (4.0 / 3 * modulus * std::sqrt(radius)), 2));
}

Scene slope(double friction, double rolling, double damping) {
  Scene scene;
  scene.model = {.gravity = gravity, .lever = Lever::radius, .rolling_smoothing = 1e-3};
  scene.contact = {.damping_factor = damping, .friction = friction, .rolling_friction = rolling};
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  scene.wall.push_back({"slope", {0, 0}, {-rise, level}, "any"});  // falls to the left
  return scene;
}

Scene block(double friction) {
  Scene scene = slope(friction, 0, 1);
  const double d = overlap(node_mass);
  Lattice node{.origin = {d * rise, -d * level}, .node_mass = node_mass, .material = "any", .gravity = true};
  node.contact_radius = radius;
  scene.lattice.push_back(node);
  return scene;
}

struct Body {
  std::string name;
  DiscMass reading;
  double c;  // I / (m R^2)
};
const Body disc{"disc", DiscMass::disc, 0.5};
const Body sphere{"sphere", DiscMass::sphere, 0.4};

// Rolling down with `speed`.
Scene wheel(const Body& body, double friction, double rolling, double speed) {
  Scene scene = slope(friction, rolling, 0.5);
  scene.model.disc_mass = body.reading;
  const bool flat = body.reading == DiscMass::disc;
  const double height = radius - overlap(density * std::numbers::pi * radius * radius * (flat ? 1 : 4 * radius / 3));
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
Rates rates_of(const Scene& scene) {
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

const Tolerance rounded = relative(1e-12, "round-off: a difference of speeds, 5e3 steps apart");

TEST(Incline, BlockStaysWhileFrictionExceedsTheSlope) {
  requirement("tangential.block_on_slope");
  const Ran ran = run_scene(block(1.2 * rise / level), "rk4", 2e-5, 0.1);
  const double d = overlap(node_mass);
  const double stretch = node_mass * gravity * rise / (8 * shear_modulus * std::sqrt(radius * d));
  const double moved =
      -((ran.y[ran.system.x_of(0)] - d * rise) * level + (ran.y[ran.system.y_of(0)] + d * level) * rise);
  expect("stretch of its spring [m]", moved, stretch, relative(4e-13, "round-off; what rang has died"));
  expect("creep [m/s]", std::hypot(ran.y[ran.system.vx_of(0)], ran.y[ran.system.vy_of(0)]), 0,
         absolute(1e-15, "round-off of g h, an ulp a step"));
}

// At 1.001 it slips while its spring is loaded, and is braked.
TEST(Incline, BlockSlidesWhenTheSlopeExceedsFriction) {
  requirement("tangential.block_on_slope");
  for (const double share : {1.001, 0.999, 0.8, 0.3}) {
    const double want = gravity * rise * (1 - share);
    expect("a [m/s^2], mu / tan theta = " + std::to_string(share), rates_of(block(share * rise / level)).acceleration,
           want, rounded);
  }
}

TEST(Incline, DiscRollsOrSlides) {
  requirement("tangential.disc_on_slope");
  for (const Body& body : {disc, sphere}) {
    const double limit = rise / level * body.c / (1 + body.c);
    const Rates rolls = rates_of(wheel(body, 1.01 * limit, 0, 0));
    expect("rolling a [m/s^2], " + body.name, rolls.acceleration, gravity * rise / (1 + body.c), rounded);
    expect("rolling omega' [rad/s^2], " + body.name, rolls.turning, gravity * rise / (1 + body.c) / radius, rounded);
    const Rates slides = rates_of(wheel(body, 0.5 * limit, 0, 0));
    expect("sliding a [m/s^2], " + body.name, slides.acceleration, gravity * (rise - 0.5 * limit * level), rounded);
    expect("sliding omega' [rad/s^2], " + body.name, slides.turning, 0.5 * limit * gravity * level / (body.c * radius),
           rounded);
  }
}

TEST(Incline, RollingFrictionSlowsTheWheel) {
  requirement("tangential.disc_on_slope");
  for (const Body& body : {disc, sphere}) {
    for (const double rolling : {0.05, 0.5}) {
      const Rates got = rates_of(wheel(body, 1, rolling, 1.0));
      expect("a [m/s^2], " + body.name + ", mu_r " + std::to_string(rolling).substr(0, 4), got.acceleration,
             gravity * (rise - rolling * level) / (1 + body.c),
             relative(2.5e-10, "smoothing: (w0/w)^2/2 of the moment, w > 85 rad/s, times mu_r cos/(sin - mu_r cos)"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification
