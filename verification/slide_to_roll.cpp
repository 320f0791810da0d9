// A disc set down sliding on a plane: friction slows it and turns it until it rolls.
//
//   m u' = -mu m g
//   c m R^2 omega' = -mu m g a        a: arm of friction, R or, with `moment_arm = "contact_point"`, R - d
//   m u - c m R^2 omega / a = m u0    stays as it is, so it rolls at the end, u = -a omega, with
//   u_f = u0 / (1 + c (R/a)^2)        2/3 u0 for a disc, 5/7 u0 for a sphere if a = R
//   t_s = (u0 - u_f) / (mu g)         from then on
//   lost 1/2 m u0 (u0 - u_f)          whatever mu
//   d = (m g / K)^(2/3)               the contact carries the weight from the start
//
// The damper is so strong that the disc slides from the start.
//
// Source: any textbook of mechanics (the sliding billiard ball); MFiX verification case DEM04.
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/launch_scene.h"
#include "verification/running.h"

namespace furrow::verification::slide_to_roll {
namespace {

TEST(SlideToRoll, SlidesUniformlyUntilItRolls) {
  requirement("tangential.slide_to_roll");
  const Tolerance in_slip = relative(1e-12, "round-off over 400 steps");
  for (const RoundBody& body : {disc, sphere}) {
    for (const double friction : {0.2, 0.6, 1.0}) {
      const double rolling_from = body.c / (1 + body.c) * launch / (friction * gravity);
      double last = 0;     // s, the last step with all of it sliding
      double vx = 0;       // m/s, then
      double surface = 0;  // m/s, omega R then
      const Scene scene = launch_scene(body, friction, young_hard, MomentArm::radius);
      const System system(scene);
      run_scene(scene, "rk4", rolling_from / 400.5, 1.01 * rolling_from,
                [&](double t, const State& y, const JumpReport&) {
                  if (y[system.vx_of(0)] + y[system.spin_of(0)] * radius <= 0) return false;
                  last = t;
                  vx = y[system.vx_of(0)];
                  surface = y[system.spin_of(0)] * radius;
                  return true;
                });
      expect("u at the last sliding step [m/s]" + which(body, friction), vx, launch - friction * gravity * last,
             in_slip);
      expect("omega R at the last sliding step [m/s]" + which(body, friction), surface,
             -friction * gravity * last / body.c, in_slip);
      expect("time of rolling [s]" + which(body, friction),
             last + (vx + surface) / (friction * gravity * (1 + 1 / body.c)), rolling_from, in_slip);
    }
  }
}

const Tolerance rounded = relative(3e-13, "round-off: m u - I omega / a is kept by every stage; what rang has died");

TEST(SlideToRoll, KeepsTwoThirdsOfItsSpeedAsADiscAndFiveSeventhsAsASphere) {
  requirement("tangential.slide_to_roll");
  for (const RoundBody& body : {disc, sphere}) {
    for (const double friction : {0.2, 1.0}) {
      const Scene scene = launch_scene(body, friction, young_hard, MomentArm::radius);
      const Ran ran = run_scene(scene, "rk4", 2e-5, 0.1);
      const double end = launch / (1 + body.c);
      expect("u at the end [m/s]" + which(body, friction), ran.y[ran.system.vx_of(0)], end, rounded);
      expect("omega R at the end [m/s]" + which(body, friction), ran.y[ran.system.spin_of(0)] * radius, -end, rounded);
      expect("energy lost [J] / (m u0^2 / 2)" + which(body, friction),
             observe(ran.system, ran.end.time, ran.y).energy.lost() / (0.5 * mass(body) * launch * launch),
             body.c / (1 + body.c),
             relative(2.2e-7, "truncation at the moment it stops sliding: order 2, 1.1e-7 measured, doubled"));
    }
  }
}

TEST(SlideToRoll, LeverToTheContactPointKeepsLess) {
  requirement("tangential.slide_to_roll");
  const double arm = radius - resting_overlap(disc, young_soft);
  const double end = launch / (1 + 0.5 * radius * radius / (arm * arm));
  Scene scene = launch_scene(disc, 0.5, young_soft, MomentArm::contact_point);
  for (const char* ground : {"wall", "plate"}) {
    if (std::string(ground) == "plate") {  // its upper face where the wall was
      scene.wall.clear();
      scene.plate.push_back({.name = "table",
                             .left_edge = -1,
                             .lower_edge = -0.1,
                             .width = 2,
                             .height = 0.1,
                             .velocity = {0, 0},
                             .material = "any"});
    }
    const Ran ran = run_scene(scene, "rk4", 1e-4, 0.3);
    expect("u at the end [m/s], on a " + std::string(ground), ran.y[ran.system.vx_of(0)], end, rounded);
    expect("omega (R - d) at the end [m/s], on a " + std::string(ground), ran.y[ran.system.spin_of(0)] * arm, -end,
           rounded);
  }
}

}  // namespace
}  // namespace furrow::verification::slide_to_roll
