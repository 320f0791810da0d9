// Mindlin's tangential spring with its force rescaled while the contact unloads.
//
//   F  = St xi, the force of the tangential spring
//   F' = St vt              while d grows:   what is there already does not grow with St
//   F' = St vt + F St'/St   while d shrinks: a smaller contact cannot hold it
//
// which in xi is, with St'/St = d'/(2 d),
//
//   xi' = vt - xi d'/(2 d)  while d' > 0
//   xi' = vt                otherwise
//
// Where Mindlin's spring without rescaling is supplied with energy as it stiffens (an impact that sticks then returns
// up to 1.04 times the slip speed for nu < 1/4), this one never is: it loses 1/4 St xi^2 |d'|/d, booked as friction,
// since it stands for slip at the edge of the contact.
//
// Source: Thornton, Cummins and Cleary 2013 (Powder Technol. 233, 30), their simplest model.
#pragma once

#include <cmath>

#include "physics/contact.h"

namespace furrow {

// m/s: xi' at a slip speed vt.
inline double rescaled_rate(const Touch& c) {
  if (!(c.approach > 0) || !(c.overlap > 0)) return c.slip;
  return c.slip - c.spring * c.approach / (2 * c.overlap);
}

// Of the powers of Mindlin's spring: what supplied it there is lost here, whichever way d changes.
inline void rescale(TouchPowers& p) {
  p.sliding += std::fabs(p.stiffening);
  p.stiffening = 0;
}

}  // namespace furrow
