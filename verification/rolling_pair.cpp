// Two spinning bodies that meet head-on: the rolling moment brakes both.
//
//   M = -mu_r R_r N s(w),  s = w / sqrt(w^2 + w0^2),  w = omega_i - omega_j
//   R_r = R_i R_j/(R_i + R_j)
//   if w stays far above w0:
//     I_i (omega_i' - omega_i) = -+ mu_r R_r m* (1 + e) v
//
// Source: algebra.
#include <string>

#include "verification/check.h"
#include "verification/rolling_scenes.h"
#include "verification/running.h"

namespace furrow::verification::rolling_resistance {
namespace {

TEST(RollingResistance, TwoThatMeetBrakeEachOther) {
  requirement("tangential.rolling_pair");
  // No friction, no damping: e = 1. The second one is larger, at rest but for its spin, and turns faster the same way.
  constexpr double other = 0.03;   // m
  constexpr double closing = 0.1;  // m/s
  for (const RoundBody& body : {disc, sphere}) {
    Scene scene = on_floor(body, 0, young, 0, 0, 0);
    scene.wall.clear();
    scene.model.gravity = 0;
    scene.model.rolling_smoothing = 1e-5;
    scene.contact.damping_factor = 0;
    scene.disc = {{{0, 0}, radius, {closing, 0}, 30, "any"}, {{radius + other, 0}, other, {0, 0}, 40, "any"}};
    const double mass2 = mass(body) * (body.reading == DiscMass::disc ? 9 : 27);
    const double impulse = 2 * closing * mass(body) * mass2 / (mass(body) + mass2);
    const double angular = rolling * radius * other / (radius + other) * impulse;  // N m s
    const Ran ran = run_scene(scene, "rk4", 1e-6, 0.01);
    expect("first spin [rad/s], " + body.name, ran.y[ran.system.spin_of(0)],
           30 + angular / (body.c * mass(body) * radius * radius),
           relative(3e-10, "truncation of order 5/2: 1.4e-10 measured, doubled"));
    expect("second spin [rad/s], " + body.name, ran.y[ran.system.spin_of(1)],
           40 - angular / (body.c * mass2 * other * other),
           relative(3e-10, "truncation of order 5/2: 1.4e-10 measured, doubled"));
  }
}

}  // namespace
}  // namespace furrow::verification::rolling_resistance
