// The linear law: a spring and a dashpot along each of normal and tangent.
//
//   Fe = kn d
//   Fv = (2 beta sqrt(kn m*) + cn) d'
//   Fn = max(0, Fe + Fv)                            without the max if the contact may pull
//   Ft = -kt xi - (2 beta sqrt(kt m*) + ct) vt,     |Ft| <= mu max(0, Fn)
//
// If the contact may pull and cn = 0, a head-on impact lasts pi/w with w = sqrt(kn/m* (1 - beta^2)), and its restitution
// is exp(-pi beta/sqrt(1 - beta^2)). At a given m* neither depends on the speed.
//
// Source: Cundall and Strack 1979 (Geotechnique 29, 47).
#pragma once

#include "physics/contact.h"

namespace furrow {

inline void stiffen_linear(const ContactLaw& law, const Touch& c, TouchForce& f) {
  f.stiffness = law.options.normal_stiffness;
  f.shear_stiffness = law.options.tangential_stiffness;
  f.elastic = f.stiffness * c.overlap;
}

}  // namespace furrow
