// The law of one contact with its options. The reference computes with it; the kernel too, contact by contact, if a law
// of the scene has an option: its vectors have none. Without options it is hertz_mindlin() of physics/contact.h.
#pragma once

#include "physics/contact.h"
#include "physics/damping.h"
#include "physics/linear.h"
#include "physics/rescaled_mindlin.h"
#include "physics/rolling_spring.h"

namespace furrow {

// The elastic force and the stiffnesses.
inline void stiffen_by_law(const ContactLaw& law, const Touch& c, TouchForce& f) {
  switch (law.options.force) {
    case ForceLaw::hertz_mindlin:
    case ForceLaw::rescaled_mindlin:
      return stiffen(law, c, f);
    case ForceLaw::linear:
      return stiffen_linear(law, c, f);
  }
}

// rolling_smoothing: rad/s, w0.
inline TouchForce contact_force(const ContactLaw& law, const Touch& c, double rolling_smoothing) {
  if (law.options.none()) return hertz_mindlin(law, c, rolling_smoothing);
  TouchForce f{};
  stiffen_by_law(law, c, f);
  damp(law, c, f);
  f.tangential = tangential_force(c, f, coulomb_limit(law, f));
  if (law.rolling > 0)
    f.moment = law.options.rolling_spring ? rolling_spring_moment(law, c, f)
                                          : rolling_moment(law, c, f.normal, rolling_smoothing);
  return f;
}

// m/s: xi'.
inline double spring_rate(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  switch (law.options.force) {
    case ForceLaw::hertz_mindlin:
    case ForceLaw::linear:
      break;
    case ForceLaw::rescaled_mindlin:
      return rescaled_rate(law, c, f);
  }
  return c.slip;
}

inline bool rolls_on_spring(const ContactLaw& law) { return law.options.rolling_spring && law.rolling > 0; }

inline TouchPowers contact_powers(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  TouchPowers p = touch_powers(c, f);
  switch (law.options.force) {
    case ForceLaw::hertz_mindlin:
      break;
    case ForceLaw::rescaled_mindlin:
      rescale(law, c, f, p);
      break;
    case ForceLaw::linear:
      keep_stiffness(p);
      break;
  }
  if (rolls_on_spring(law)) store_rolling(law, c, f, p);
  return p;
}

struct SpringEnergies {
  double tangential, rolling;  // J, stored: 1/2 St xi^2 and 1/2 kr theta^2
};

inline SpringEnergies spring_energies(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  return {0.5 * f.shear_stiffness * c.spring * c.spring,
          rolls_on_spring(law) ? 0.5 * rolling_stiffness(law, c, f) * c.turn * c.turn : 0};
}

// J, in the normal spring: the work that pressed it.
inline double normal_energy(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  switch (law.options.force) {
    case ForceLaw::hertz_mindlin:
    case ForceLaw::rescaled_mindlin:
      break;
    case ForceLaw::linear:
      return linear_energy(f.elastic, c.overlap);
  }
  return elastic_energy(f.elastic, c.overlap);
}

// J, in the normal spring, the tangential one and that of rolling.
inline double stored_energy(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  const SpringEnergies springs = spring_energies(law, c, f);
  return normal_energy(law, c, f) + springs.tangential + springs.rolling;
}

// J: what the springs of a contact still hold as it opens, and then lose. Zero if the stiffness vanishes at d = 0; else
// 1/2 k x^2, with k the stiffness and x the displacement, xi or theta.
inline SpringEnergies energy_at_opening(const ContactLaw& law, double reduced_radius, double spring, double turn) {
  Touch c{};
  c.reduced_radius = reduced_radius;
  c.spring = spring;
  c.turn = turn;
  TouchForce f{};
  if (has_constant_stiffness(law.options.force)) stiffen_by_law(law, c, f);
  return spring_energies(law, c, f);
}

}  // namespace furrow
