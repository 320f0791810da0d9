// Head-on impacts for the pages on normal contact: materials of the literature, what is measured
// on a run, and how far an elastic impact may be from Hertz.
#pragma once

#include <algorithm>
#include <cmath>

#include "verification/check.h"
#include "verification/hertz_law.h"
#include "verification/running.h"

namespace furrow::verification {

struct Matter {
  const char* name;
  double young;    // Pa
  double poisson;  // -
  double density;  // kg/m^3
};

// Of the tests of Chung and Ooi 2011, Granular Matter 13, 643.
inline constexpr Matter glass{"glass", 4.8e10, 0.20, 2800};
inline constexpr Matter limestone{"limestone", 2.0e10, 0.25, 2500};
inline constexpr Matter aluminium{"aluminium alloy", 7.0e10, 0.30, 2699};
inline constexpr Matter magnesium{"magnesium alloy", 4.0e10, 0.35, 1800};
inline constexpr Matter alumina{"aluminium oxide", 3.8e11, 0.23, 4000};
inline constexpr Matter cast_iron{"cast iron", 1.0e11, 0.25, 7000};

// (1 - nu^2)/E, 1/Pa.
inline double softness(const Matter& m) { return (1 - m.poisson * m.poisson) / m.young; }

inline double mass_of(const Matter& m, double radius, DiscMass reading) {  // kg; a disc is 1 m deep
  const double circle = 3.14159265358979323846 * radius * radius;
  return m.density * (reading == DiscMass::disc ? circle : circle * radius * 4 / 3);
}

// ---- scenes ----

inline void add_disc(Scene& scene, const Matter& m, double radius, Vec2 position, Vec2 velocity) {
  scene.material.push_back({.name = m.name, .density = m.density, .young = m.young, .poisson = m.poisson});
  scene.disc.push_back({.position = position, .radius = radius, .velocity = velocity, .material = m.name});
}

inline Scene impact_scene(DiscMass reading) {
  Scene scene;
  scene.title = "head-on impact";
  scene.model.gravity = 0;
  scene.model.disc_mass = reading;
  scene.output.energy = false;
  return scene;
}

// A disc, its centre at the origin, that touches a wall at this moment and runs into it along the normal (nx, ny).
inline Scene wall_impact(const Matter& m, double radius, double speed, DiscMass reading, bool rigid, double nx = 0,
                         double ny = 1) {
  Scene scene = impact_scene(reading);
  add_disc(scene, m, radius, {0, 0}, {-speed * nx, -speed * ny});
  scene.material.push_back({.name = "rigid", .rigid = true});
  scene.wall.push_back(
      {.point = {-radius * nx, -radius * ny}, .normal = {nx, ny}, .material = rigid ? "rigid" : m.name});
  return scene;
}

// ---- measurements ----

// The greatest value of a smooth series at equal steps: vertex of the parabola through the three highest.
class Crest {
 public:
  void add(double value) {
    if (seen_ >= 2 && b_ > a_ && b_ >= value) {
      const double rise = value - a_;
      highest_ = std::max(highest_, b_ - rise * rise / (8 * (a_ - 2 * b_ + value)));
    }
    a_ = b_;
    b_ = value;
    ++seen_;
  }
  double highest() const { return highest_; }

 private:
  double a_ = 0, b_ = 0, highest_ = 0;
  int seen_ = 0;
};

struct Impact {
  double peak_overlap = 0, peak_force = 0;  // m, N
  double least_force = infinity;            // N, repulsive if positive
  double contact_time = 0;                  // s
  double rebound = 0;                       // speed of separation over speed of approach
  State y;                                  // at the end
};

struct Plan {
  const char* method;
  double step;             // s
  double end;              // s
  double tolerance = 0;    // relative, of a controlled method
  double length_unit = 1;  // m, to which the controlled method's absolute tolerance refers
  double hit = 0;          // s, a moment that the controlled method must not step over
};

// Disc 0, of mass m0, against wall 0 or disc 1.
inline Impact measure(const Scene& scene, double m0, const Plan& plan) {
  System system(scene);
  Impact got;
  got.y = system.initial_state();
  const bool pair = scene.disc.size() > 1;
  const auto difference = [&](const State& y, int x_of, int y_of, double n0, double n1) {
    const double x = y[x_of] - (pair ? y[x_of + 1] : 0);
    const double height = y[y_of] - (pair ? y[y_of + 1] : 0);
    return x * n0 + height * n1;
  };
  Vec2 n{1, 0};  // from the other body to disc 0
  if (pair) {
    const double x = got.y[0] - got.y[1];
    const double height = got.y[system.y_of(0)] - got.y[system.y_of(1)];
    n = {x / std::hypot(x, height), height / std::hypot(x, height)};
  } else {
    const double length = std::hypot(scene.wall[0].normal.x, scene.wall[0].normal.y);
    n = {scene.wall[0].normal.x / length, scene.wall[0].normal.y / length};
  }
  const double touch = pair ? scene.disc[0].radius + scene.disc[1].radius : 0;
  Crest overlap;
  Crest force;
  double before = 0;
  double released = 0;
  State rate(system.size());
  const double arriving = difference(got.y, system.vx_of(0), system.vy_of(0), n.x, n.y);
  const auto method = make_method(
      plan.method,
      {.relative = plan.tolerance, .absolute = plan.tolerance * plan.length_unit, .first_step = 1e-6 * plan.step});
  const auto stop = [&plan](double t) { return t < plan.hit ? plan.hit : plan.end; };
  run(system, *method, got.y, {.start = 0, .end = plan.end, .step = plan.step, .stop = stop},
      [&](double t, const State& y, const JumpReport&) {
        const double depth = touch - difference(y, system.x_of(0), system.y_of(0), n.x, n.y);
        system.rhs(t, y, rate);
        const double push = m0 * (rate[system.vx_of(0)] * n.x + rate[system.vy_of(0)] * n.y);
        overlap.add(depth);
        force.add(push);
        got.least_force = std::min(got.least_force, push);
        if (before > 0 && depth <= 0) released = t + depth / difference(y, system.vx_of(0), system.vy_of(0), n.x, n.y);
        before = depth;
        return true;
      });
  got.peak_overlap = overlap.highest();
  got.peak_force = force.highest();
  got.contact_time = released;
  got.rebound = -difference(got.y, system.vx_of(0), system.vy_of(0), n.x, n.y) / arriving;
  return got;
}

// Error of rk4 with N steps in an elastic contact that begins at a step, as a fraction. The force starts as t^(3/2), so
// that the first step errs by h^(5/2) in position; what that does to the energy cancels at the way out, up to order 5.
// In units of the impact all elastic impacts are the same one, so that the constants hold for every material, mass and
// speed; measured once, at N = 200, and doubled.
struct ElasticError {
  int steps;
  Tolerance overlap() const { return of(2 * 0.037, 2.5); }
  Tolerance force() const { return of(2 * 0.055, 2.5); }
  Tolerance time() const { return of(2 * 0.0101, 2.5); }
  Tolerance speed() const { return of(2 * 23.8, 5); }

 private:
  Tolerance of(double constant, double order) const {
    return relative(constant * std::pow(steps, -order),
                    "truncation of rk4: C N^-" + std::string(order == 5 ? "5" : "5/2") + ", C measured once, doubled");
  }
};

// Runs with rk4, `steps` in a contact time.
inline Impact expect_hertz(const std::string& what, const Hertz& h, const Scene& scene, double m0, int steps) {
  const ElasticError error{steps};
  Impact got = measure(scene, m0, {"rk4", h.contact_time() / steps, 1.1 * h.contact_time()});
  expect(what + ": greatest overlap [m]", got.peak_overlap, h.peak_overlap(), error.overlap());
  expect(what + ": greatest force [N]", got.peak_force, h.peak_force(), error.force());
  expect(what + ": contact time [s]", got.contact_time, h.contact_time(), error.time());
  expect(what + ": speed after over before", got.rebound, 1, error.speed());
  return got;
}

// Of a table with eight or seven digits.
inline Tolerance last_digit(double value) { return relative(value, "half a unit of the last digit of the table"); }

}  // namespace furrow::verification
