// A block and a disc on a slope: what sticks, what slides and what rolls.
//
//   block (a node):
//     mu > tan theta: it stays, after the spring has stretched by m g sin theta / St
//     else it slides:  a = g (sin theta - mu cos theta)
//   disc:
//     mu > tan theta c / (1 + c): it rolls,   a = g sin theta / (1 + c)
//     with rolling friction:                  a = g (sin theta - mu_r cos theta) / (1 + c)
//     else it slides:                         a = g (sin theta - mu cos theta),  omega' = mu g cos theta / (c R)
//   St = 8 G* sqrt(R* d),  d = (m g cos theta / K)^(2/3),  K = 4/3 E* sqrt(R*)
//
// Moment arms are radii here.
//
// Source: any textbook of mechanics; with rolling friction LAMMPS, granular tests, incline_rolling.
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/slope_scenes.h"

namespace furrow::verification::incline {
namespace {

const Tolerance rounded = relative(1e-12, "round-off: a difference of speeds over 5e3 steps");

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
  for (const RoundBody& body : {disc, sphere}) {
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
  for (const RoundBody& body : {disc, sphere}) {
    for (const double rolling : {0.05, 0.5}) {
      const Rates got = rates_of(wheel(body, 1, rolling, 1.0));
      expect("a [m/s^2], " + body.name + ", mu_r " + std::to_string(rolling).substr(0, 4), got.acceleration,
             gravity * (rise - rolling * level) / (1 + body.c),
             relative(2.5e-10, "smoothing: (w0/w)^2/2 of the moment, w > 85 rad/s, times mu_r cos/(sin - mu_r cos)"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification::incline
