// What follows from the law of a contact for a head-on impact: estimates, for advice on steps and for what is watched
// in a run. No run's state depends on them, except where events are located: time_scale_to_the_fifth() grades the steps
// after a touch (run/events.h). Hertz's stand here, the linear law's in physics/linear.h. Constant dashpots are left out:
// with them an impact goes less deep.
#pragma once

#include <cmath>

#include "physics/contact_force.h"

namespace furrow {

inline bool is_linear(const ContactLaw& law) { return has_constant_stiffness(law.options.force); }

// -: beta, of the linear oscillator that an impact is like.
inline double damping_ratio_of_impact(const ContactLaw& law) {
  return is_linear(law) ? damping_ratio_of_linear(law) : law.viscosity / (2 * std::sqrt(5.0 / 6.0));
}

// J: the work that presses two bodies to this overlap, by law, from R* and d (m). The one of physics/contact.h is Hertz's
// alone, from Fe and d. Bodies that meet with more energy, m* v^2/2, go deeper.
inline double elastic_energy(const ContactLaw& law, double reduced_radius, double overlap) {
  if (is_linear(law)) return linear_work(law, overlap);
  return 8.0 / 15.0 * law.modulus * std::sqrt(reduced_radius * overlap) * overlap * overlap;
}

// -: how much lower a damped impact peaks than an elastic one, in the quantity that is a linear oscillator of damping
// ratio beta. Of the linear law that is d, so this is d_damped/d_elastic; of Hertz's it is d^(5/4) (Antypov and Elliott
// 2011, EPL 94, 50004), so this is (d_damped/d_elastic)^(5/4). Its first peak is
//
//   exp(-beta/r atan(r/beta)),    r = sqrt(1 - beta^2)
//   exp(-beta/r artanh(r/beta)),  r = sqrt(beta^2 - 1),  beyond beta = 1
inline double impact_factor(const ContactLaw& law) {
  const double beta = damping_ratio_of_impact(law);
  const double r = std::sqrt(std::fabs(1 - beta * beta));
  if (beta == 0) return 1;
  if (r < 1e-6) return std::exp(-1.0);
  return std::exp(-beta / r * (beta < 1 ? std::atan(r / beta) : std::atanh(r / beta)));
}

// m: how deep an elastic head-on impact goes.
inline double impact_overlap(const ContactLaw& law, double reduced_radius, double reduced_mass, double speed) {
  if (is_linear(law)) return linear_impact_overlap(law, reduced_mass, speed);
  const double factor = 4.0 / 3.0 * law.modulus * std::sqrt(reduced_radius);
  return std::pow(5 * reduced_mass * speed * speed / (4 * factor), 0.4);
}

// s: how long it lasts, of Hertz's law 4 sqrt(pi)/5 Gamma(2/5)/Gamma(9/10) d/v with its greatest overlap d.
inline double impact_duration(const ContactLaw& law, double overlap, double speed) {
  return is_linear(law) ? linear_impact_duration(overlap, speed) : 2.943275184324047 * overlap / speed;
}

// rad/s: of the oscillator that an elastic impact is like, sqrt(Sn/m*) at its greatest overlap.
inline double impact_frequency(const ContactLaw& law, double overlap, double speed) {
  return is_linear(law) ? linear_impact_frequency(overlap, speed) : std::sqrt(15.0 / 8.0) * speed / overlap;
}

// Of Hertz's law. s^5: the fifth power of a contact's time scale, (m*^2 / (E*^2 R* v))^(1/5) / max(1, beta)^(4/5). Its root
// is left to the caller (run/events.cpp), for std::pow has not the same bits on every machine.
inline double time_scale_to_the_fifth(const ContactLaw& law, double reduced_radius, double reduced_mass, double speed) {
  const double beta = damping_ratio_of_impact(law);
  const double damped = beta > 1 ? beta : 1;
  const double elastic = law.modulus * law.modulus * reduced_radius * speed;
  return reduced_mass * reduced_mass / (elastic * damped * damped * damped * damped);
}

}  // namespace furrow
