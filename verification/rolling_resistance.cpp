// The rolling moment alone: a disc that spins in place, one that rolls on a plane or creeps on a slope.
//
//   M = -mu_r R N s(omega),  s = omega / sqrt(omega^2 + w0^2)
//   in place (mu = 0, nothing moves the centre):
//     c R omega' = -mu_r g s
//     f(omega) = sqrt(omega^2 + w0^2) - w0 asinh(w0 / omega) falls as f0 - mu_r g t / (c R)
//   rolling, the arm of friction a:
//     u' = -mu_r g (R/a) / (1 + c (R/a)^2);  a = R: mu_r g 2/3 (disc), 5/7 (sphere)
//   on a slope below mu_r, no rest but w with s(w) = tan theta / mu_r:
//     w = w0 tan theta / sqrt(mu_r^2 - tan^2 theta)
//
// Sources: algebra; in place LAMMPS, granular tests, rolling_decay.
#include <cmath>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/rolling_scenes.h"
#include "verification/running.h"

namespace furrow::verification::rolling_resistance {
namespace {

TEST(RollingResistance, SpinInPlaceDecays) {
  requirement("tangential.rolling_decay");
  for (const RoundBody& body : {disc, sphere}) {
    for (const double w0 : {1e-5, 1.0, 20.0}) {
      for (const double spin : {20.0, -20.0}) {
        Scene scene = on_floor(body, 0, young, 0, 0, spin);
        scene.model.rolling_smoothing = w0;
        const double end = 0.5 * falling(spin, w0) * body.c * radius / (rolling * gravity);
        const Ran ran = run_scene(scene, "rk4", end / 200, end);
        const double got = ran.y[ran.system.spin_of(0)];
        const std::string which =
            ", " + body.name + ", w0 " + std::to_string(w0).substr(0, 7) + (spin > 0 ? ", left" : ", right");
        expect("f(omega) / f0" + which, falling(got, w0) / falling(spin, w0), 0.5,
               relative(2e-13, "round-off over 200 steps; truncation is below it"));
        expect_true("it does not turn round" + which, got * spin > 0, "the moment opposes the spin");
        expect("lost to rolling / energy lost" + which,
               observe(ran.system, ran.end.time, ran.y).energy.rolling /
                   (0.5 * body.c * mass(body) * radius * radius * (spin * spin - got * got)),
               1, relative(2e-13, "round-off over 200 steps; truncation is below it"));
      }
    }
  }
}

TEST(RollingResistance, WheelSlowsMoreGentlyThanASpinInPlace) {
  requirement("tangential.rolling_decay");
  for (const RoundBody& body : {disc, sphere}) {
    for (const MomentArm moment_arm : {MomentArm::radius, MomentArm::contact_point}) {
      const double sinking = moment_arm == MomentArm::contact_point ? overlap(mass(body) * gravity, soft) : 0;
      const double arm = radius - sinking;
      Scene scene = on_floor(body, 1, moment_arm == MomentArm::contact_point ? soft : young, 0, 1, -1 / arm);
      scene.model.moment_arm = moment_arm;
      scene.model.rolling_smoothing = 1e-3;
      const System system(scene);
      double early = 0;
      const Ran ran = run_scene(scene, "rk4", 2e-5, 0.4, [&](double t, const State& y, const JumpReport&) {
        if (t < 0.2 + 1e-9) early = y[system.vx_of(0)];
        return true;
      });
      expect("u' [m/s^2], " + body.name + (moment_arm == MomentArm::contact_point ? ", arm R - d" : ", arm R"),
             (ran.y[ran.system.vx_of(0)] - early) / 0.2,
             -rolling * gravity * (radius / arm) / (1 + body.c * radius * radius / (arm * arm)),
             relative(2e-10, "smoothing takes (w0/w)^2/2 off the moment: 9e-11 at 74 rad/s, doubled"));
    }
  }
}

TEST(RollingResistance, SmoothedMomentLetsItCreepOnASlope) {
  requirement("tangential.rolling_creep");
  constexpr double rise = 0.06;
  const double slope = rise / std::sqrt(1 - rise * rise);
  for (const RoundBody& body : {disc, sphere}) {
    for (const double w0 : {0.03, 0.3}) {
      Scene scene = on_floor(body, 1, young, rise, 0, 0);
      scene.model.rolling_smoothing = w0;
      const Ran ran = run_scene(scene, "rk4", 2e-5, 0.5);
      expect("omega [rad/s], " + body.name + ", w0 " + std::to_string(w0).substr(0, 4), ran.y[ran.system.spin_of(0)],
             w0 * slope / std::sqrt(rolling * rolling - slope * slope),
             relative(1e-12, "round-off; what was to decay has, to e^-30"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification::rolling_resistance
