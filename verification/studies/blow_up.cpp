#include "verification/studies/blow_up.h"

#include <algorithm>
#include <cmath>

#include "methods/method.h"
#include "run/run.h"
#include "verification/studies/amplification.h"
#include "verification/studies/growth.h"

namespace furrow::verification {
namespace {

constexpr double fine = 1e-3;  // of the limit

Scene empty_scene() {
  Scene scene;
  scene.output.energy = false;
  scene.time.end = 1e6;
  return scene;
}

}  // namespace

Oscillation spring_oscillation(double zeta) {
  Oscillation o{empty_scene(), 1, 1, 0};
  o.scene.title = "a mass on a damped spring";
  o.scene.model.gravity = 0;
  o.scene.material.push_back({.name = "any", .young = 1, .poisson = 0.3});
  Lattice spring;
  spring.rows = 1;
  spring.columns = 2;
  spring.spacing = o.rest;
  spring.node_mass = 1;
  spring.material = "any";
  spring.fixed_columns = {0};
  spring.structural = {.stiffness = 1, .damping = 2 * zeta};
  constexpr double push = 1e-6;  // m, m/s: large against round-off; the spring is linear at any length
  spring.node.push_back({.row = 0, .column = 1, .displacement = {push, 0}, .velocity = {push, 0}});
  o.scene.lattice.push_back(spring);
  return o;
}

Oscillation contact_oscillation(double zeta) {
  constexpr double radius = 0.01, young = 1e7, poisson = 0.3;  // m, Pa
  Oscillation o{empty_scene(), 1, 0, 1};
  o.scene.title = "a disc that rests on a wall";
  o.scene.contact.damping_factor = zeta / std::sqrt(5.0 / 6.0);
  o.scene.material.push_back({.name = "soft", .density = 1000, .young = young, .poisson = poisson});
  o.scene.material.push_back({.name = "rigid", .rigid = true});
  const double modulus = young / (1 - poisson * poisson);
  const double mass = 1000 * 3.14159265358979323846 * radius * radius;
  const double overlap = std::pow(0.75 * mass * o.scene.model.gravity / (modulus * std::sqrt(radius)), 2.0 / 3.0);
  o.omega = std::sqrt(2 * modulus * std::sqrt(radius * overlap) / mass);
  o.rest = radius - overlap;
  const double away = 1e-6 * overlap;  // linear, even if it grows a thousandfold
  o.scene.disc.push_back(
      {.position = {0, o.rest + away}, .radius = radius, .velocity = {0, o.omega * away}, .material = "soft"});
  o.scene.wall.push_back({.name = "floor", .material = "rigid"});
  return o;
}

bool grows(const std::string& method, const Oscillation& o, double angle) {
  System system(o.scene);
  State y = system.initial_state();
  const int steps = 4 * static_cast<int>(std::max(1000.0, 20 / angle));  // three periods a quarter
  const double step = angle / o.omega;
  const int v = o.axis + 2;  // [x, y, vx, vy]
  Growth growth(steps, growth_seen);
  const RunPlan plan{.start = 0, .end = (steps + 0.5) * step, .step = step, .stop = {}};
  const RunEnd end = run(system, *make_method(method), y, plan, [&](double, const State& now, const JumpReport&) {
    return growth.add(std::hypot(now[o.axis] - o.rest, now[v] / o.omega));  // without damping it does not swing
  });
  return end.ending == Ending::diverged || growth.seen();
}

double measured_stable_angle(const std::string& method, const Oscillation& oscillation, double guess) {
  double stable = 0;
  double unstable = guess * 1.03;
  if (grows(method, oscillation, unstable) && !grows(method, oscillation, guess * 0.97)) {
    stable = guess * 0.97;
  } else {  // outwards from far below
    unstable = 1e-3;
    while (!grows(method, oscillation, unstable)) {
      stable = unstable;
      unstable *= 1.1;
      if (unstable > largest_angle) return largest_angle;
    }
  }
  while (unstable - stable > fine * unstable) {
    const double middle = 0.5 * (stable + unstable);
    (grows(method, oscillation, middle) ? unstable : stable) = middle;
  }
  return 0.5 * (stable + unstable);
}

}  // namespace furrow::verification
