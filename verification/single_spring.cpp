// A mass on a spring, in every regime of damping.
//
//   m x'' + c x' + k x = 0,   x(0) = x0, x'(0) = 0,   omega = sqrt(k/m), zeta = c / (2 sqrt(k m))
//   zeta < 1:  x = x0 e^(-zeta omega t) (cos(wd t) + zeta omega/wd sin(wd t)),  wd = omega sqrt(1 - zeta^2)
//   zeta = 1:  x = x0 e^(-omega t) (1 + omega t)
//   zeta > 1:  x = x0 (r2 e^(r1 t) - r1 e^(r2 t)) / (r2 - r1),  r = -zeta omega +- omega sqrt(zeta^2 - 1)
//
// Source: any textbook of mechanics, for example Meirovitch, Fundamentals of Vibrations, chapter 2.
#include <cmath>

#include "system/observe.h"
#include "system/run.h"
#include "verification/check.h"

namespace furrow::verification {
namespace {

constexpr double mass = 5;         // kg
constexpr double stiffness = 500;  // N/m
constexpr double stretch = 0.01;   // m
constexpr double omega = 10;       // rad/s, sqrt(500 / 5)
constexpr double end = 1.0;        // s

// Written apart from the solver: a closed form a regime.
double exact_position(double zeta, double t) {
  if (zeta == 1) return stretch * std::exp(-omega * t) * (1 + omega * t);
  if (zeta < 1) {
    const double wd = omega * std::sqrt(1 - zeta * zeta);
    return stretch * std::exp(-zeta * omega * t) * (std::cos(wd * t) + zeta * omega / wd * std::sin(wd * t));
  }
  const double root = omega * std::sqrt(zeta * zeta - 1);
  const double r1 = -zeta * omega + root;
  const double r2 = -zeta * omega - root;
  return stretch * (r2 * std::exp(r1 * t) - r1 * std::exp(r2 * t)) / (r2 - r1);
}

// The oracle's oracle: the same equation by Taylor series in steps so short that round-off is all that is left.
double series_position(double zeta, double t) {
  constexpr int steps = 200;
  long double x = stretch;
  long double v = 0;
  const long double h = static_cast<long double>(t) / steps;
  for (int n = 0; n < steps; ++n) {
    long double a = x;  // k-th Taylor coefficients of x; x'' = -2 zeta omega x' - omega^2 x
    long double b = v;
    long double power = 1;
    long double new_x = 0;
    long double new_v = 0;
    for (int k = 0; k < 25; ++k) {
      new_x += a * power;
      new_v += b * power;
      const long double next = b / (k + 1);
      b = (-2 * static_cast<long double>(zeta) * omega * b - static_cast<long double>(omega) * omega * a) / (k + 1);
      a = next;
      power *= h;
    }
    x = new_x;
    v = new_v;
  }
  return static_cast<double>(x);
}

Scene spring_scene(double zeta) {
  Scene scene;
  scene.title = "a mass on a spring";
  scene.model.gravity = 0;
  scene.material.push_back({.name = "any", .young = 2e5, .poisson = 0.3});
  Lattice spring;
  spring.rows = 1;
  spring.columns = 2;
  spring.spacing = 0.1;
  spring.node_mass = mass;
  spring.material = "any";
  spring.fixed_columns = {0};
  spring.structural = {.stiffness = stiffness, .damping = 2 * zeta * std::sqrt(stiffness * mass)};
  spring.node.push_back({.row = 0, .column = 1, .displacement = {stretch, 0}});
  scene.lattice.push_back(spring);
  return scene;
}

// Stretch of the spring at the end, m.
double position_at_end(double zeta, const char* method, double step) {
  System system(spring_scene(zeta));
  State y = system.initial_state();
  run(system, *make_method(method), y, {.start = 0, .end = end, .step = step},
      [](double, const State&, const JumpReport&) { return true; });
  return y[system.x_of(0)] - 0.1;
}

TEST(SingleSpring, ClosedFormsAgreeWithTheirTaylorSeries) {
  requirement("spring.damped");
  for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0, 5.0}) {
    expect("x(1 s) / x0 by series, damping ratio " + std::to_string(zeta), series_position(zeta, end) / stretch,
           exact_position(zeta, end) / stretch, absolute(1e-14, "round-off of a few exponentials in double precision"));
  }
}

TEST(SingleSpring, FollowsTheExactSolutionInEveryRegimeOfDamping) {
  requirement("spring.damped");
  // rk4 at omega h = 0.01: its error is at most (omega h)^4 / 120 a radian, over 10 rad; with damping less.
  constexpr double bound = 1e-8 / 120 * 10;
  for (const double zeta : {0.0, 0.05, 0.5, 1.0, 2.0}) {
    expect("x(1 s) / x0, damping ratio " + std::to_string(zeta), position_at_end(zeta, "rk4", 1e-3) / stretch,
           exact_position(zeta, end) / stretch,
           absolute(2 * bound * (1 + 16 * zeta * zeta * zeta * zeta),
                    "truncation of rk4: (omega h)^4/120 a radian over 10 rad, times the fourth power of the fastest "
                    "rate, doubled"));
  }
}

}  // namespace
}  // namespace furrow::verification
