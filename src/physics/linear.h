// The linear law: a spring and a dashpot along each of normal and tangent.
//
//   Fe = kn d
//   Fv = (2 beta sqrt(kn m*) + cn) d'
//   Fn = max(0, Fe + Fv)                            without the max if the contact may pull
//   Ft = -kt xi - (2 beta sqrt(kt m*) + ct) vt,     |Ft| <= mu max(0, Fn)
//
// If the contact may pull and cn = 0, a head-on impact lasts pi/w with w = sqrt(kn/m* (1 - beta^2)), and its restitution
// is exp(-pi beta/sqrt(1 - beta^2)). At a given m* neither depends on the speed. Without damping it goes v sqrt(m*/kn)
// deep, d, and lasts pi d/v.
//
// Source: Cundall and Strack 1979 (Geotechnique 29, 47).
#pragma once

#include <cmath>

#include "physics/contact.h"

namespace furrow {

// kn, kt: N/m.
inline void make_linear(ContactLaw& law, double kn, double kt, double beta) {
  law.options.force = ForceLaw::linear;
  law.options.normal_stiffness = kn;
  law.options.tangential_stiffness = kt;
  law.viscosity = 2 * beta;
  law.shear_ratio = std::sqrt(kt / kn);
}

inline void stiffen_linear(const ContactLaw& law, const Touch& c, TouchForce& f) {
  f.stiffness = law.options.normal_stiffness;
  f.shear_stiffness = law.options.tangential_stiffness;
  f.elastic = f.stiffness * c.overlap;
}

// J, stored in the normal spring: the integral of Fe (N) from 0 to d (m), from both. From d alone: linear_work().
inline double linear_energy(double elastic, double overlap) { return 0.5 * elastic * overlap; }

// The stiffnesses are constant: no energy is supplied by a change of them.
inline void keep_stiffness(TouchPowers& p) { p.stiffening = 0; }

// ---- a head-on impact: estimates, see physics/impact.h ----

inline double damping_ratio_of_linear(const ContactLaw& law) { return law.viscosity / 2; }  // -, beta

// J: the work that presses two bodies to this overlap (m).
inline double linear_work(const ContactLaw& law, double overlap) {
  return 0.5 * law.options.normal_stiffness * overlap * overlap;
}

// m: d, without damping; reduced_mass: kg; speed: m/s.
inline double linear_impact_overlap(const ContactLaw& law, double reduced_mass, double speed) {
  return speed * std::sqrt(reduced_mass / law.options.normal_stiffness);
}

inline double linear_impact_duration(double overlap, double speed) { return pi * overlap / speed; }  // s
inline double linear_impact_frequency(double overlap, double speed) { return speed / overlap; }      // rad/s

}  // namespace furrow
