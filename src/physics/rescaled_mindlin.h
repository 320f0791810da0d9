// Mindlin's tangential spring, whose force falls with the contact's stiffness while d shrinks and does not grow with it
// while d grows.
//
//   F  = St xi                     what the spring is loaded with; the spring's part of Ft (physics/contact.h) is -F
//   F' = St vt + (F - F*) St'/St   while d grows: F* is not scaled up; it is F within |F*| <= mu Fe
//   F' = St vt + F St'/St          while d shrinks: a smaller contact cannot hold it
//
// which in xi (m) is, with St'/St = d'/(2 d),
//
//   xi' = vt - xi* d'/(2 d)  while d' > 0,  xi* = xi within |xi*| <= mu Fe/St = mu E* d/(6 G*)
//   xi' = vt                 otherwise
//
// Why xi*: xi can exceed mu Fe/St within a step, or because its limit after a step is that of the damped Fn. As d -> 0,
// xi d'/(2 d) is then unbounded; xi* d'/(2 d) is at most mu E* d'/(12 G*). After the step the spring is reset by the rules
// of physics/damping.h, as any other.
//
// Mindlin's spring without rescaling is supplied with energy as it stiffens: after an impact that sticks the slip is up
// to 1/cos(pi/10) = 1.05 times that before, of spheres with nu < 1/4 (verification/sticking_impact.cpp). This spring
// loses 1/4 St xi^2 |d'|/d instead, booked as friction. While d shrinks that stands for slip at the edge of the contact;
// while d grows nothing slips, and the loss follows from counting the energy as F^2/(2 St). Of a spring beyond xi* it is
// 1/4 St xi (2 xi* - xi) d'/d while d grows; beyond 2 xi* energy is supplied, and booked as `stiffening`.
//
// Source: Thornton, Cummins and Cleary 2013 (Powder Technol. 233, 30), their simplest model.
#pragma once

#include <cmath>

#include "physics/contact.h"

namespace furrow {

inline bool loads(const Touch& c) { return c.approach > 0 && c.overlap > 0; }

// m: xi*, the part of xi that the elastic force Fe holds. Not Fn: the damper's part of it jumps at an impact.
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
