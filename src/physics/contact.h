// Hertz-Mindlin contact without slip, with viscous damping and the Coulomb limit.
//
//   1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j
//   1/G* = (2 - nu_i)/G_i + (2 - nu_j)/G_j
//   1/R* = 1/R_i + 1/R_j
//   1/m* = 1/m_i + 1/m_j
//
//   Fe = 4/3 E* sqrt(R*) d^(3/2)
//   Sn = 2 E* sqrt(R* d)
//   Fv = 2 sqrt(5/6) beta sqrt(Sn m*) d'
//   Fn = max(0, Fe + Fv)
//   St = 8 G* sqrt(R* d)
//   Ft = -St xi - 2 sqrt(5/6) beta sqrt(St m*) vt,  |Ft| <= mu Fn
//   M  = -mu_r R* Fn w / sqrt(w^2 + w0^2)
//
// with overlap d > 0, approach speed d', slip speed vt, tangential displacement xi, relative spin w. R* is also
// R_i R_j/(R_i + R_j), the rolling radius.
// Sources: Hertz 1882; Mindlin 1949; damping after Tsuji, Tanaka and Ishida 1992 (Powder Technol. 71, 239) in the form
// of Di Renzo and Di Maio 2004 (Chem. Eng. Sci. 59, 525). Valid for small overlap against the radius; the paper's soil
// is so soft that d reaches 0.8 R, where this is a penalty law.
#pragma once

#include <cmath>

#include "physics/disc.h"

namespace furrow {

struct Elastic {
  double young = 0;    // Pa
  double poisson = 0;  // -
  bool rigid = false;  // its terms in 1/E* and 1/G* are zero
};

// Constants of a pair of materials.
struct ContactLaw {
  double modulus = 0;        // Pa, E*
  double shear_modulus = 0;  // Pa, G*
  double viscosity = 0;      // -, 2 sqrt(5/6) beta
  double shear_ratio = 0;    // -, sqrt(St/Sn) = 2 sqrt(G*/E*)
  double friction = 0;       // -, mu
  double rolling = 0;        // -, mu_r
  double floor = 0;          // N, least normal force: 0, or -infinity if the contact may pull
};

inline double compliance(const Elastic& e) { return e.rigid ? 0 : (1 - e.poisson * e.poisson) / e.young; }

inline double shear_compliance(const Elastic& e) {
  return e.rigid ? 0 : (2 - e.poisson) * 2 * (1 + e.poisson) / e.young;  // G = E / (2 (1 + nu))
}

inline ContactLaw contact_law(const Elastic& i, const Elastic& j, double beta, double mu, double mu_rolling,
                              bool pull) {
  ContactLaw law;
  law.modulus = 1 / (compliance(i) + compliance(j));
  law.shear_modulus = 1 / (shear_compliance(i) + shear_compliance(j));
  law.viscosity = 2 * std::sqrt(5.0 / 6.0) * beta;
  law.shear_ratio = 2 * std::sqrt(law.shear_modulus / law.modulus);
  law.friction = mu;
  law.rolling = mu_rolling;
  law.floor = pull ? -HUGE_VAL : 0;
  return law;
}

// beta for a wanted restitution e in (0, 1]; exact if the contact may pull.
inline double damping_factor(double restitution) {
  const double log_e = std::log(restitution);
  return -log_e / std::sqrt(log_e * log_e + pi * pi);
}

// One touching contact as the law sees it.
struct Touch {
  double overlap;         // m, > 0
  double approach;        // m/s, d'
  double slip;            // m/s, vt: of the two surfaces at the contact, spin included
  double spring;          // m, xi
  double spin;            // rad/s, omega_i - omega_j
  double reduced_radius;  // m, R*
  double reduced_mass;    // kg, m*
};

struct TouchForce {
  double elastic;          // N, Fe
  double normal;           // N, Fn, pushing the two apart
  double tangential;       // N, Ft on body i, along the tangent
  double moment;           // N m, M on body i
  double stiffness;        // N/m, Sn
  double shear_stiffness;  // N/m, St
  double shear_viscosity;  // N s/m, factor of vt in Ft
};

// The first half of the law: what does not depend on slip, spring and spin.
[[gnu::always_inline]] inline void press(const ContactLaw& law, const Touch& c, TouchForce& f) {
  const double root = std::sqrt(c.reduced_radius * c.overlap);
  f.stiffness = 2 * law.modulus * root;
  f.shear_stiffness = 8 * law.shear_modulus * root;
  f.elastic = (2.0 / 3.0) * f.stiffness * c.overlap;
  const double viscosity = law.viscosity * std::sqrt(f.stiffness * c.reduced_mass);
  f.shear_viscosity = viscosity * law.shear_ratio;

  const double push = f.elastic + viscosity * c.approach;
  f.normal = push > law.floor ? push : law.floor;
}

// N, on the tangential force.
[[gnu::always_inline]] inline double coulomb_limit(const ContactLaw& law, const TouchForce& f) {
  return law.friction * (f.normal > 0 ? f.normal : 0);
}

// m: |xi| is at most mu Fn / St.
[[gnu::always_inline]] inline double returned_spring(double limit, const TouchForce& f, double spring) {
  const double reach = limit / f.shear_stiffness;
  return spring > reach ? reach : spring < -reach ? -reach : spring;
}

// The second half: N, on body i along the tangent.
[[gnu::always_inline]] inline double tangential_force(const Touch& c, const TouchForce& f, double limit) {
  const double stick = -f.shear_stiffness * c.spring - f.shear_viscosity * c.slip;
  const double capped = stick > limit ? limit : stick;
  return capped < -limit ? -limit : capped;
}

// N m, on body i.
[[gnu::always_inline]] inline double rolling_moment(const ContactLaw& law, const Touch& c, double normal,
                                                    double rolling_smoothing) {
  const double pressed = normal > 0 ? normal : 0;
  return -law.rolling * c.reduced_radius * pressed * c.spin /
         std::sqrt(c.spin * c.spin + rolling_smoothing * rolling_smoothing);
}

// The whole law. rolling_smoothing: rad/s, w0.
inline TouchForce hertz_mindlin(const ContactLaw& law, const Touch& c, double rolling_smoothing) {
  TouchForce f{};
  press(law, c, f);
  f.tangential = tangential_force(c, f, coulomb_limit(law, f));
  f.moment = law.rolling > 0 ? rolling_moment(law, c, f.normal, rolling_smoothing) : 0;
  return f;
}

// W, what one contact takes or gives, by cause. The tangential spring holds 1/2 St xi^2, and St goes with sqrt(d):
//
//   d/dt (1/2 St xi^2) = St xi vt + 1/4 xi^2 St d'/d
//
// The second term, `stiffening`, is paid for by no force: a property of Mindlin's law without rescaling.
struct TouchPowers {
  double viscous;     // of the normal damper
  double sticking;    // of the tangential damper, while the contact sticks
  double sliding;     // heat of friction, while it slides
  double rolling;     // heat of rolling friction, as the moment's power: negative
  double stiffening;  // given to the tangential spring
};

[[gnu::always_inline]] inline TouchPowers touch_powers(const Touch& c, const TouchForce& f) {
  const double stick = -f.shear_stiffness * c.spring - f.shear_viscosity * c.slip;
  const double lost = -f.tangential * c.slip - f.shear_stiffness * c.spring * c.slip;
  const bool sticks = stick == f.tangential;
  const double rate = 0.25 * c.spring * c.spring * f.shear_stiffness * c.approach / c.overlap;
  return {(f.normal - f.elastic) * c.approach, sticks ? lost : 0, sticks ? 0 : lost, f.moment * c.spin,
          c.overlap > 0 ? rate : 0};  // two discs exactly at touch have none
}

// Their sums.
struct ContactPowers {
  double viscous = 0, friction = 0, rolling = 0, stiffening = 0;  // W

  void add(const TouchPowers& one, bool of_friction) {
    viscous += one.viscous;
    if (!of_friction) return;
    viscous += one.sticking;
    friction += one.sliding;
    rolling -= one.rolling;
    stiffening += one.stiffening;
  }
  void add(const ContactPowers& others) {
    viscous += others.viscous;
    friction += others.friction;
    rolling += others.rolling;
    stiffening += others.stiffening;
  }
};

// What the normal spring holds: the integral of Fe from 0 to d.
inline double elastic_energy(double elastic, double overlap) { return 0.4 * elastic * overlap; }

// J: the same, of a contact of which only the overlap is known. Two that meet with more kinetic energy, m* v^2/2, go
// deeper.
inline double elastic_energy(const ContactLaw& law, double reduced_radius, double overlap) {
  return 8.0 / 15.0 * law.modulus * std::sqrt(reduced_radius * overlap) * overlap * overlap;
}

// -: what damping leaves of the depth of a head-on impact, as d^(5/4): with z = d^(5/4) this law is a linear oscillator
// of damping ratio beta (Antypov and Elliott 2011, EPL 94, 50004), whose first peak is
//
//   exp(-beta/r atan(r/beta)),    r = sqrt(1 - beta^2)
//   exp(-beta/r artanh(r/beta)),  r = sqrt(beta^2 - 1),  beyond beta = 1
inline double impact_factor(const ContactLaw& law) {
  const double beta = law.viscosity / (2 * std::sqrt(5.0 / 6.0));
  const double r = std::sqrt(std::fabs(1 - beta * beta));
  if (beta == 0) return 1;
  if (r < 1e-6) return std::exp(-1.0);
  return std::exp(-beta / r * (beta < 1 ? std::atan(r / beta) : std::atanh(r / beta)));
}

// m: how deep an elastic head-on impact goes.
inline double impact_overlap(const ContactLaw& law, double reduced_radius, double reduced_mass, double speed) {
  const double factor = 4.0 / 3.0 * law.modulus * std::sqrt(reduced_radius);
  return std::pow(5 * reduced_mass * speed * speed / (4 * factor), 0.4);
}

// s: how long it lasts, 4 sqrt(pi)/5 Gamma(2/5)/Gamma(9/10) d/v with its greatest overlap d.
inline double impact_duration(double overlap, double speed) { return 2.943275184324047 * overlap / speed; }

// rad/s: of the oscillator that an elastic impact is like, sqrt(Sn/m*) at its greatest overlap.
inline double impact_frequency(double overlap, double speed) { return std::sqrt(15.0 / 8.0) * speed / overlap; }

// s^5: the fifth power of a contact's time scale, (m*^2 / (E*^2 R* v))^(1/5) / max(1, beta)^(4/5).
inline double time_scale_to_the_fifth(const ContactLaw& law, double reduced_radius, double reduced_mass, double speed) {
  const double beta = law.viscosity / (2 * std::sqrt(5.0 / 6.0));
  const double damped = beta > 1 ? beta : 1;
  const double elastic = law.modulus * law.modulus * reduced_radius * speed;
  return reduced_mass * reduced_mass / (elastic * damped * damped * damped * damped);
}

}  // namespace furrow
