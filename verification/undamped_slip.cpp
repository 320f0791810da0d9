// An oblique impact that sticks, damped along its normal by a factor and not at all along the tangent.
//
//   linear law, m d'' = -max(0, kn d + c d'), which lets go after t_c, where the force would pull
//   t_c = (pi - atan2(2 beta w', w'^2 - beta^2))/wd,  w' = sqrt(1 - beta^2),  wd = w w',  w = sqrt(kn/m)
//   m vt' = -kappa kt xi,  xi' = vt,  kappa = 1 + m R^2/I:  vt(t_c)/vt(0) = cos(wt t_c),  wt = sqrt(kappa kt/m)
//
// Along the tangent nothing but a spring acts (`slip_damping = false`), however the factor of the normal damping is given.
//
// Sources: Schwager and Poeschel 2007 (Granular Matter 9, 465) for t_c; Cundall and Strack 1979 (Geotechnique 29, 47).
#include "verification/linear_scenes.h"

namespace furrow::verification::linear {
namespace {

constexpr double ratio = 0.8;     // kt/kn
constexpr double sideways = 1.5;  // m/s

double time_in_contact(double beta) {
  const double w = std::sqrt(1 - beta * beta);
  return (std::numbers::pi - std::atan2(2 * beta * w, w * w - beta * beta)) / (omega(disc) * w);
}

TEST(UndampedSlip, SticksAsOnASpringAloneHoweverTheNormalDampingIsGiven) {
  requirement("tangential.after_slip");
  for (const double e : {0.3, 0.7}) {
    for (const bool by_restitution : {false, true}) {
      Scene scene = impact(disc);
      scene.disc[0].velocity.x = sideways;
      scene.model.slip_damping = false;
      scene.contact.friction = 1e12;
      scene.contact.tangential_stiffness = ratio * stiffness;
      (by_restitution ? scene.contact.restitution : scene.contact.damping_factor) = by_restitution ? e : beta_of(e);
      const double time = time_in_contact(beta_of(e));
      const Ran ran = run_scene(scene, "rk4", time / 20000.7, 1.1 * time);
      const double slip = ran.y[ran.system.vx_of(0)] + radius * ran.y[ran.system.spin_of(0)];
      expect("slip after over before, e = " + std::to_string(e) + (by_restitution ? ", by it" : ", by the factor"),
             slip / sideways, std::cos(std::sqrt(ratio * disc.kappa()) * omega(disc) * time),
             absolute(2e-4, "order 1 where the contact opens with its spring stretched, at 0.7 of a step of 5e-5"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification::linear
