// Mindlin's tangential spring with its force rescaled while the contact unloads.
//
//   F  = St xi, the force of the tangential spring
//   F' = St vt              while d grows:   what is there already does not grow with St
//   F' = St vt + F St'/St   while d shrinks: a smaller contact cannot hold it
//
// which in xi is, with St'/St = d'/(2 d),
//
//   xi' = vt - xi* d'/(2 d)  while d' > 0,  xi* = xi within |xi*| <= mu Fe/St
//   xi' = vt                 otherwise
//
// Within a step xi may be beyond what friction holds, and d as small as round-off: xi d'/(2 d) has no bound there, but
// mu Fe/St, by the elastic force Fe, goes to zero with d. (By the damped force Fn it would grow as d^(-1/4).) What is
// beyond mu Fn/St is taken away after the step, see contact.h.
//
// Where Mindlin's spring without rescaling is supplied with energy as it stiffens (an impact that sticks then returns
// up to 1.04 times the slip speed for nu < 1/4), this one is not within xi*: it loses 1/4 St xi^2 |d'|/d, booked as
// friction, since it stands for slip at the edge of the contact. Of a spring beyond, 1/4 St xi (2 xi* - xi) d'/d while d
// grows; beyond 2 xi* that is supplied, and booked as `stiffening`.
//
// Source: Thornton, Cummins and Cleary 2013 (Powder Technol. 233, 30), their simplest model.
#pragma once

#include <cmath>

#include "physics/contact.h"

namespace furrow {

inline bool loads(const Touch& c) { return c.approach > 0 && c.overlap > 0; }

// m: xi*.
inline double held_spring(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  return returned_spring(law.friction * f.elastic, f, c.spring);
}

// m/s: xi' at a slip speed vt.
inline double rescaled_rate(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  return loads(c) ? c.slip - held_spring(law, c, f) * c.approach / (2 * c.overlap) : c.slip;
}

// Of the powers of Mindlin's spring: the part by its stiffening is lost here, or supplied beyond 2 xi*.
inline void rescale(const ContactLaw& law, const Touch& c, const TouchForce& f, TouchPowers& p) {
  const double spring = loads(c) ? 2 * held_spring(law, c, f) - c.spring : -c.spring;
  const double lost = c.overlap > 0 ? 0.25 * f.shear_stiffness * c.spring * spring * c.approach / c.overlap : 0;
  p.sliding += lost > 0 ? lost : 0;
  p.stiffening = lost < 0 ? -lost : 0;
}

}  // namespace furrow
