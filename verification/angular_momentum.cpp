// A cluster of discs that rub and roll on each other keeps its momentum and its angular momentum.
//
//   kept:  sum of m v
//          sum of x (x) m v + I omega
//
// Newton's third law, and two moment arms that add up to the distance. Velocity Verlet keeps both to round-off: at each
// evaluation the forces, and their moments about the origin, add up to zero.
//
// Source: any textbook of mechanics; angular momentum with friction as in Spheral's DEM tests.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification::angular_momentum {
namespace {

constexpr double density = 1000;  // kg/m^3
constexpr double young = 1e5;     // Pa
constexpr double poisson = 0.3;   // -

double mass(double radius) { return density * std::numbers::pi * radius * radius; }  // kg, depth 1 m

// Seven unequal discs fly together, with friction, rolling friction and damping.
Scene cluster(DiscMass reading) {
  Scene scene;
  scene.model = {.gravity = 0, .disc_mass = reading};
  scene.contact = {.damping_factor = 0.3, .friction = 0.4, .rolling_friction = 0.1};
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  for (int i = 0; i < 7; ++i) {
    const double angle = 0.9 * i;
    const double away = i == 0 ? 0 : 0.03;
    const double inward = i == 0 ? 0 : -0.3 - 0.05 * i;
    scene.disc.push_back({{0.2 + away * std::cos(angle), 0.1 + away * std::sin(angle)},
                          0.009 + 0.001 * i,
                          {inward * std::cos(angle) - 0.1 * std::sin(angle), inward * std::sin(angle) + 0.1},
                          20.0 - 7 * i,
                          "any"});
  }
  return scene;
}

TEST(NewtonsCradle, ClusterKeepsItsAngularMomentum) {
  requirement("assembly.angular_momentum");
  for (const DiscMass reading : {DiscMass::disc, DiscMass::sphere}) {
    const Scene scene = cluster(reading);
    const System system(scene);
    double start[3] = {};
    double scale = 0;
    double worst[3] = {};
    int most = 0;
    run_scene(scene, "verlet", 1e-5, 0.2, [&](double t, const State& y, const JumpReport&) {
      const Observation seen = observe(system, t, y);
      most = std::max(most, seen.contacts);
      double now[3] = {};
      double magnitude = 0;
      for (std::size_t i = 0; i < scene.disc.size(); ++i) {
        const int k = static_cast<int>(i);
        const double r = scene.disc[i].radius;
        const bool flat = reading == DiscMass::disc;
        const double m = mass(r) * (flat ? 1 : 4 * r / 3);
        const double px = m * y[system.vx_of(k)];
        const double py = m * y[system.vy_of(k)];
        now[0] += px;
        now[1] += py;
        now[2] +=
            y[system.x_of(k)] * py - y[system.y_of(k)] * px + (flat ? 0.5 : 0.4) * m * r * r * y[system.spin_of(k)];
        magnitude += m * 0.3;
      }
      if (t == 0) {
        std::copy(now, now + 3, start);
        scale = magnitude;  // N s
      }
      for (int c = 0; c < 3; ++c)
        worst[c] = std::max(worst[c], std::fabs(now[c] - start[c]) / (scale * (c < 2 ? 1 : 0.2)));
      return true;
    });
    const std::string which = reading == DiscMass::disc ? ", discs" : ", spheres";
    const Tolerance rounded = absolute(6e-15, "round-off: 20000 steps, 3e-15 measured, doubled");
    const Tolerance turned = absolute(
        5e-13,
        "round-off of the positions, all to one side in flight: grows with the steps; 2.2e-13 measured, doubled");
    expect("greatest change of momentum along x" + which, worst[0], 0, rounded);
    expect("greatest change of momentum along y" + which, worst[1], 0, rounded);
    expect("greatest change of angular momentum" + which, worst[2], 0, turned);
    expect_true("more than two pairs touch at once" + which, most > 2, "else there is nothing to keep");
  }
}

}  // namespace
}  // namespace furrow::verification::angular_momentum
