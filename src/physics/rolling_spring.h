// Rolling resistance by a spring, a dashpot and a limit: a disc can rest on a slope.
//
//   theta' = w = omega_i - omega_j
//   kr = 3 Sn mu_r^2 R*^2, or as given
//   cr = 2 eta_r sqrt(Ir kr)
//   Ir = 1/(1/(I_i + m_i R_i^2) + 1/(I_j + m_j R_j^2)),  without the second term if b is no disc
//   M  = -kr theta - cr w,  |M| <= mu_r R* max(0, Fn)
//
// theta: rad; kr: N m; cr: N m s; Ir: kg m^2. After each step |theta| is limited to mu_r R* Fn/kr.
//
// A disc at rest on a slope of angle alpha has Fn = m g cos(alpha), |Ft| = m g sin(alpha) and |M| = arm |Ft|. With
// |Ft| <= mu Fn and |M| <= mu_r R* Fn it can rest if
//
//   tan(alpha) <= min(mu, mu_r R*/arm)
//
// where R* = R, and arm is R - d by default (system/contact.h).
//
// The factor 3 is that of discs: springs spread over a width B give the moment Sn B^2/12 per angle, and B = 6 mu_r R*
// lets it reach its limit, Fn B/6, where the pressure at one edge vanishes. Spheres, with a round contact of that width,
// would have 2.25, and a limit of Fn B/8; 3 is taken for both.
//
// Source: model C of Ai, Chen, Rotter and Ooi 2011 (Powder Technol. 206, 269), whose viscous moment is not limited below
// full mobilisation, and multiplied by a factor beyond; here the limit is that of the sum, as for sliding.
#pragma once

#include <cmath>

#include "physics/contact.h"

namespace furrow {

// N m
inline double rolling_stiffness(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  if (law.options.rolling_stiffness > 0) return law.options.rolling_stiffness;
  const double arm = law.rolling * c.reduced_radius;
  return 3 * f.stiffness * arm * arm;
}

// N m s: cr, of a stiffness kr (N m).
inline double rolling_spring_viscosity(const ContactLaw& law, const Touch& c, double kr) {
  return 2 * law.options.rolling_damping * std::sqrt(c.rolling_inertia * kr);
}

// N m: the greatest moment.
inline double rolling_limit(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  return law.rolling * c.reduced_radius * (f.normal > 0 ? f.normal : 0);
}

// N m, on body i.
inline double rolling_spring_moment(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  const double kr = rolling_stiffness(law, c, f);
  const double cr = rolling_spring_viscosity(law, c, kr);
  const double limit = rolling_limit(law, c, f);
  const double free = -kr * c.turn - cr * c.spin;
  const double capped = free > limit ? limit : free;
  return capped < -limit ? -limit : capped;
}

// rad: theta after a step. Where nothing is stiff it stays as it is.
inline double turn_after_step(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  const double reach = rolling_limit(law, c, f) / rolling_stiffness(law, c, f);
  return c.turn > reach ? reach : c.turn < -reach ? -reach : c.turn;
}

// What the spring takes up is not lost; a stiffness that grows with the contact supplies it.
inline void store_rolling(const ContactLaw& law, const Touch& c, const TouchForce& f, TouchPowers& p) {
  const double kr = rolling_stiffness(law, c, f);
  p.rolling -= kr * c.turn * c.spin;
  if (law.options.rolling_stiffness > 0 || has_constant_stiffness(law.options.force) || !(c.overlap > 0)) return;
  p.stiffening += 0.25 * c.turn * c.turn * kr * c.approach / c.overlap;
}

}  // namespace furrow
