// The spring of a disc that sticks: what a touch within a step costs, that each impact begins without stretch, and
// where the energy comes from that a sticking contact gains.
//
//   spring   xi' = vt from the first stage that touches on: short by up to a step of slip, order 1
//   energy   in units of m/kappa vt^2/2 an impact gains e_t^2 - 1, all of it by the stiffening of the spring:
//            1/4 xi^2 St d'/d
//
// Source: the closed form of sticking_impact.cpp.
#include <cmath>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/sticking_scenes.h"

namespace furrow::verification::sticking_impact {
namespace {

TEST(StickingImpact, TouchInsideAStepCostsTheFirstOrder) {
  requirement("tangential.sticking");
  // The slip enters the spring from the first stage that touches: the spring is short by up to a step of slip.
  constexpr int steps = 4000;
  const Tolerance truncation =
      absolute(2.8 / steps, "truncation: xi' jumps from 0 to vt at touch, so order 1; 1.4/n measured, doubled");
  for (const double gap : {0.2, 0.5, 0.9}) {
    const Ran ran = run_impact(disc, 0.3, steps, gap);
    expect("e_t, touch at " + std::to_string(gap).substr(0, 3) + " of a step",
           (ran.y[ran.system.vx_of(0)] + radius * ran.y[ran.system.spin_of(0)]) / slip,
           restitution(shear_ratio(0.3), disc.c), truncation);
    const TwoDiscs two;
    const Ran pair = two.run(steps, gap);
    const auto& at = pair.system;
    const double left = pair.y[at.vy_of(0)] - pair.y[at.vy_of(1)] + radius * pair.y[at.spin_of(0)] +
                        TwoDiscs::other * pair.y[at.spin_of(1)];
    expect("e_t of two discs, touch at " + std::to_string(gap).substr(0, 3) + " of a step", left / two.start,
           restitution(shear_ratio(TwoDiscs::nu), disc.c), truncation);
  }
}

TEST(StickingImpact, EveryImpactBeginsWithARelaxedSpring) {
  requirement("tangential.sticking");
  // Floor, lid, floor: the slip is vx + omega R below and vx - omega R above; each impact sees its own one only.
  constexpr int steps = 4000;
  constexpr double nu = 0.5;  // e_t = 0.17: the spring is still stretched when the contact opens
  const double time = contact_time(mass(disc), radius, young / (2 * (1 - nu * nu)), closing);
  constexpr double room = 0.005;  // m
  Scene scene = impact(disc, nu, radius + room / 2);
  scene.wall.push_back({"lid", {0, 2 * radius + room}, {0, -1}, "any"});
  const Ran ran = run_scene(scene, "rk4", time / (steps + 0.7), 3 * time + 3 * room / closing);
  double vx = sideways;
  double surface = spin * radius;
  for (const double side : {1.0, -1.0, 1.0}) {
    const double lost = (1 - restitution(shear_ratio(nu), disc.c)) * (vx + side * surface) / (1 + 1 / disc.c);
    vx -= lost;
    surface -= side * lost / disc.c;
  }
  const Tolerance truncation = absolute(2.8 / steps * slip, "truncation: touches inside a step, as above");
  expect("vx [m/s]", ran.y[ran.system.vx_of(0)], vx, truncation);
  expect("spin R [m/s]", ran.y[ran.system.spin_of(0)] * radius, surface, truncation);
}

TEST(StickingImpact, GainOfEnergyIsBookedAsStiffening) {
  requirement("tangential.stiffening");
  // All of it in units of 1/2 m/kappa vt^2. A sphere at nu = 0 and a disc of the paper's nu = -1/2 gain.
  for (const RoundBody& body : {disc, sphere}) {
    for (const double nu : {-0.5, 0.0, 0.5}) {
      const double e_t = restitution(shear_ratio(nu), body.c);
      const double scale = 0.5 * mass(body) / (1 + 1 / body.c) * slip * slip;
      const double start =
          0.5 * mass(body) * (sideways * sideways + closing * closing + body.c * radius * radius * spin * spin);
      Energies end[2];
      for (const int k : {0, 1}) {
        const Ran ran = run_impact(body, nu, k == 0 ? 4000 : 16000);
        end[k] = observe(ran.system, ran.end.time, ran.y).energy;
      }
      expect("gain of energy" + which(body, nu), (end[1].kinetic - start) / scale, e_t * e_t - 1,
             absolute(2.4 * std::pow(16000, -1.5), "truncation of order 3/2 of e_t, as above, twice as much in e_t^2"));
      expect(
          "stiffening" + which(body, nu), (2 * end[1].stiffening - end[0].stiffening) / scale, e_t * e_t - 1,
          absolute(4e-6,
                   "the ledger leaves as 1/sqrt(d): order 1/2, extrapolated from steps h and h/4: 2e-6 left, doubled"));
      expect("lost to friction and viscosity" + which(body, nu), end[1].lost() / scale, 0,
             exact("no slip and no damping"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification::sticking_impact
