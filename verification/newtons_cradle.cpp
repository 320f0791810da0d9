// A row of discs hands on momentum: pair by pair as bodies that bounce, all at once without loss.
//
//   pair, e = 1:
//     v1' = (m1 - m2)/(m1 + m2) v1
//     v2' = 2 m1/(m1 + m2) v1;  towards heavier discs no pair meets twice
//   all at once:
//     sum of m v and energy are kept
//
// Velocity Verlet keeps the momentum to round-off: at each evaluation the forces add up to zero.
//
// Source: any textbook of mechanics.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification::newtons_cradle {
namespace {

constexpr double density = 1000;  // kg/m^3
constexpr double young = 1e7;     // Pa
constexpr double poisson = 0.3;   // -
constexpr double speed = 0.5;     // m/s

double mass(double radius) { return density * std::numbers::pi * radius * radius; }  // kg, depth 1 m

Scene space() {
  Scene scene;
  scene.model.gravity = 0;
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  return scene;
}

// Touching, or with gaps between; the first one moves.
Scene cradle(const std::vector<double>& radius, double gap) {
  Scene scene = space();
  double x = 0;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    if (i > 0) x += radius[i - 1] + gap + radius[i];
    scene.disc.push_back({{x, 0}, radius[i], {i == 0 ? speed : 0, 0}, 0, "any"});
  }
  return scene;
}

TEST(NewtonsCradle, HandsOnFromPairToPair) {
  requirement("assembly.cradle");
  const std::vector<double> radius{0.01, 0.012, 0.015, 0.02};
  const Ran ran = run_scene(cradle(radius, 0.002), "rk4", 2e-6, 0.05);
  double incoming = speed;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const bool last = i + 1 == radius.size();
    const double m1 = mass(radius[i]);
    const double m2 = last ? 0 : mass(radius[i + 1]);
    expect("velocity of disc " + std::to_string(i) + " [m/s]", ran.y[ran.system.vx_of(static_cast<int>(i))],
           last ? incoming : (m1 - m2) / (m1 + m2) * incoming,
           absolute(5e-11, "truncation: 2.2e-11 measured, doubled"));
    incoming *= 2 * m1 / (m1 + m2);
  }
}

TEST(NewtonsCradle, KeepsMomentumAndEnergy) {
  requirement("assembly.cradle");
  const std::vector<double> radius(5, 0.01);
  const double momentum = mass(0.01) * speed;
  const double energy = 0.5 * momentum * speed;
  const Scene scene = cradle(radius, 0);
  const System system(scene);
  struct Row {
    const char* method;
    double tolerance;
    std::string reason;
  };
  for (const Row& row : {Row{"verlet", 4.5e-7, "order 2: 2.2e-7 measured at h = 5e-6 s, doubled"},
                         Row{"pece", 8e-7, "order 2: 3.9e-7 measured at h = 5e-6 s, doubled"},
                         Row{"rk4", 7e-10, "order 5/2 at touch: 3.3e-10 measured at h = 5e-6 s, doubled"}}) {
    double worst_momentum = 0;
    double worst_energy = 0;
    run_scene(scene, row.method, 5e-6, 0.01, [&](double t, const State& y, const JumpReport&) {
      const Observation seen = observe(system, t, y);
      worst_momentum = std::max(worst_momentum, std::fabs(seen.momentum.x / momentum - 1));
      worst_energy = std::max(worst_energy, std::fabs(seen.energy.stored() / energy - 1));
      return true;
    });
    expect(std::string("greatest error of momentum, ") + row.method, worst_momentum, 0,
           absolute(6e-15, "round-off: 2000 steps add up to 11 ulp"));
    expect(std::string("greatest error of energy, ") + row.method, worst_energy, 0,
           absolute(row.tolerance, row.reason));
  }
}

}  // namespace
}  // namespace furrow::verification::newtons_cradle
