// A plate that is set in motion gradually pushes a disc that it touches, through a linear spring.
//
//   plate  xp = a t^2/2 up to t = T, then a T (t - T/2);  a = v/T
//   m x'' = kn (xp - x), x(0) = x'(0) = 0, w = sqrt(kn/m)
//   up to T     xp - x = a/w^2 (1 - cos w t)
//   from T on   xp - x = d(T) cos w(t - T) + d'(T)/w sin w(t - T),  while it is positive
//
// Nothing is hit: the force begins with zero, and at T it has no jump.
#include <cmath>
#include <numbers>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

constexpr double kn = 1e4, speed = 0.5, radius = 0.05;          // N/m, m/s, m
const double mass = 1000 * std::numbers::pi * radius * radius;  // kg
const double w = std::sqrt(kn / mass);
const double ramp = 2.3 / w, a = speed / ramp;

Scene pushed() {
  Scene scene;
  scene.model = {.gravity = 0, .law = ForceLaw::linear};
  scene.contact.normal_stiffness = kn;
  scene.material = {{.name = "any", .rigid = true}};
  scene.disc = {{{radius, 0}, radius, {}, 0, "any"}};
  scene.plate = {{.left_edge = -0.02,
                  .lower_edge = -0.5,
                  .width = 0.02,
                  .height = 1,
                  .velocity = {speed, 0},
                  .ramp = ramp,
                  .material = "any"}};
  return scene;
}

double depth(double t) {
  if (t <= ramp) return a / (w * w) * (1 - std::cos(w * t));
  const double s = w * (t - ramp);
  return depth(ramp) * std::cos(s) + a / (w * w) * std::sin(w * ramp) * std::sin(s);
}

TEST(PlateRamp, PushesADiscAsTheClosedFormSays) {
  requirement("coupling.ramp");
  for (const double t : {0.7 * ramp, ramp, 1.3 * ramp}) {
    const Ran ran = run_scene(pushed(), "rk4", ramp / 2000, t);
    const double plate = t < ramp ? a * t * t / 2 : speed * (t - ramp / 2);
    const std::string at = " at " + std::to_string(t / ramp) + " ramps";
    const auto truncation = relative(1e-9, "of rk4 at 1/900 of a radian, to the fourth order; T is the end of a step");
    expect("way of the disc [m]" + at, ran.y[0] - radius, plate - depth(t), truncation);
    const Observation seen = observe(ran.system, t, ran.y);
    expect("force on the plate [N]" + at, seen.plate[0].x, -kn * depth(t), relative(1e-8, "truncation"));
    expect("energy residual [J]" + at, seen.energy.residual({}), 0,
           absolute(1e-9 * mass * speed * speed, "truncation"));
  }
}

}  // namespace
}  // namespace furrow::verification
