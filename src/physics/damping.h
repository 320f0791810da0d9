// The ways to give the damping of a contact, and what its tangential spring holds after it has slipped.
//
//   Fv = Cn d',     Cn = 2 sqrt(5/6) beta sqrt(Sn m*) + cn    N s/m
//   Fv,t = -Ct vt,  Ct = 2 sqrt(5/6) beta sqrt(St m*) + ct    N s/m; Fv,t is a part of Ft
//
// The linear law has 2 beta in place of 2 sqrt(5/6) beta.
//
//   damping_factor  beta
//   restitution     beta = -ln e / sqrt(ln^2 e + pi^2)                     exact if the contact may pull
//   tsuji_alpha     beta = alpha / sqrt(5)                                 not for the linear law; Ct stays as above
//   damping         cn, and ct (if not given: cn); then beta = 0
//
// At touch, d = 0, Fn jumps from 0 to Cn d' where Cn does not vanish: with cn, and with beta of the linear law. Hertz's
// Cn by beta grows from 0 like d^(1/4).
//
// After a step a spring beyond its limit is reset by one of two rules:
//
//   elastic        |xi| <= mu Fn/St                        even if spring plus damper are within the limit
//   less_viscous   xi = -(Ft + Ct vt)/St,  |Ft| = mu Fn    where the contact slides: spring and damper together reach the
//                                                          limit, as in LAMMPS; a spring that was never stretched stays
//                                                          at zero
//
// The first shortens xi; the second can also lengthen or reverse it. A reset books 1/2 St (old xi^2 - new xi^2) as heat of
// friction, which is negative where |xi| grows.
//
// Limit of less_viscous with stiffnesses that grow from nothing (Hertz-Mindlin, rescaled Mindlin): a contact that slides
// from its first touch on, with vt > 0, gets xi = (mu Fn - Ct vt)/St. As d -> 0, by beta alone, Fn and Ct ~ d^(1/4) and
// St ~ d^(1/2):
//
//   xi           ~ d^(-1/4)                        no bound
//   St xi        ~ d^(1/4)                         the force has one
//   1/2 St xi^2  ~ 1                               the energy has one
//   1/2 St' xi^2 = 1/4 St xi^2 d'/d ~ 1/d          W: supplied as `stiffening`, and lost as friction_work
//
// From the first jump on, at d ~ h for a step h, both entries grow like log(1/h); they have opposite signs in the balance
// and cancel. In the first steps d changes by a share that does not depend on h, so the ledger closes no better at finer
// steps. With ct, which does not vanish with d, xi ~ d^(-1/2) and the energy ~ d^(-1/2): it has no bound either. By the
// linear law all stay bounded, for kt is constant, and the ledger closes.
//
// Sources: Tsuji, Tanaka and Ishida 1992 (Powder Technol. 71, 239), whose normal viscous force is
// alpha sqrt(m* K) d^(1/4) d' with Fe = K d^(3/2), and whose tangential damper is the normal one: alpha is theirs, Ct is
// not; Antypov and Elliott 2011 (Europhys. Lett. 94, 50004) for the restitution; Luding 2008 (Granular
// Matter 10, 235) for the second rule after slip.
#pragma once

#include <cmath>

#include "physics/contact.h"

namespace furrow {

// beta for a wanted restitution e in (0, 1]; exact if the contact may pull.
inline double damping_factor(double restitution) {
  const double log_e = std::log(restitution);
  return -log_e / std::sqrt(log_e * log_e + pi * pi);
}

inline double damping_factor_of_tsuji(double alpha) { return alpha / std::sqrt(5.0); }

// N s/m: Cn.
inline double normal_viscosity(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  return viscosity_of_factor(law, c, f) + law.options.dashpot;
}

// Adds the dampers to a contact whose stiffnesses and elastic force are known.
inline void damp(const ContactLaw& law, const Touch& c, TouchForce& f) {
  f.shear_viscosity = viscosity_of_factor(law, c, f) * law.shear_ratio + law.options.tangential_dashpot;
  const double push = f.elastic + normal_viscosity(law, c, f) * c.approach;
  f.normal = push > law.floor ? push : law.floor;
}

// m: xi after a step.
inline double spring_after_step(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  const double limit = coulomb_limit(law, f);
  if (law.options.after_slip == AfterSlip::elastic) return returned_spring(limit, f, c.spring);
  const double stick = -f.shear_stiffness * c.spring - f.shear_viscosity * c.slip;
  if (!(std::fabs(stick) > limit) || c.spring == 0 || !(f.shear_stiffness > 0)) return c.spring;
  return -((stick > 0 ? limit : -limit) + f.shear_viscosity * c.slip) / f.shear_stiffness;
}

}  // namespace furrow
