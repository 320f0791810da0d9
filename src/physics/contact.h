// The contact law of Hertz and Mindlin: Hertz's normal force, Mindlin's tangential stiffness without slip, viscous
// damping of both, and sliding at the Coulomb limit.
//
//   1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j
//   1/G* = (2 - nu_i)/G_i + (2 - nu_j)/G_j
//   1/R* = 1/R_i + 1/R_j
//   1/m* = 1/m_i + 1/m_j                            of two bodies; of a body and a lattice: system/contact.h
//
//   Fe = 4/3 E* sqrt(R*) d^(3/2)
//   Sn = 2 E* sqrt(R* d)
//   Fv = 2 sqrt(5/6) beta sqrt(Sn m*) d'
//   Fn = max(0, Fe + Fv)                            without the max if the contact may pull
//   St = 8 G* sqrt(R* d)
//   xi' = vt                                        while the two touch; |xi| is limited after each step (damping.h)
//   Ft = -St xi - 2 sqrt(5/6) beta sqrt(St m*) vt,  |Ft| <= mu max(0, Fn)
//   M  = -mu_r R* max(0, Fn) w / sqrt(w^2 + w0^2)
//
//   E, nu, G = E/(2 (1 + nu))   Young's modulus (Pa), Poisson's ratio (-), shear modulus (Pa) of a material
//   R, m                        radius (m) and mass (kg) of a body
//   d >= 0, d'                  overlap (m; may round to 0 for two discs that just touch), approach speed (m/s)
//   xi, vt                      tangential displacement (m) and slip speed (m/s)
//   w = omega_i - omega_j       relative spin (rad/s); what is no disc has none (system/contact.h)
//   w0                          rolling_smoothing (rad/s), above 0. No static resistance: a disc creeps
//   beta, mu, mu_r              damping factor, friction and rolling friction of a pair of materials (-); static and
//                               kinetic friction have the same mu
//
// Signs. n points from body i to body j, t = (-ny, nx) is the tangent, v = v_i - v_j the relative velocity at the contact
// without spins (m/s), arm the moment arm (m). Spins, torques and rolling angles are positive counter-clockwise.
//
//   d'           = v . n
//   vt           = v . t + arm_i omega_i + arm_j omega_j
//   force on i   = -Fn n + Ft t                     N, on j the opposite
//   torque on i  = arm_i Ft + M                     N m
//   torque on j  = arm_j Ft - M                     N m
//
// Spheres touch by this law; discs of a given depth do so too, for the paper gives discs the law of spheres. R* serves
// as the rolling radius too. Which radius, mass, moment arm and normal each kind of contact has: system/contact.h. The
// life of xi: system/discrete.h. What follows for an impact: physics/impact.h.
//
// Sources: Hertz 1882; Mindlin 1949; normal damping after Tsuji, Tanaka and Ishida 1992 (Powder Technol. 71, 239),
// both dampers in the form of Di Renzo and Di Maio 2004 (Chem. Eng. Sci. 59, 525); the rolling moment is the paper's
// (README.md), with its sign function smoothed over w0. Valid for small overlap against the radius; the soil of the
// paper is so soft that d reaches 1.6 R, where this is a penalty law. The moment arm on a flat, R - d, is negative from
// d = R on: there the spin enters vt, and Ft the torque, with the opposite sign.
#pragma once

#include <cmath>

#include "physics/constants.h"
#include "physics/options.h"

namespace furrow {

struct Elastic {
  double young = 0;    // Pa
  double poisson = 0;  // -
  bool rigid = false;  // its terms in 1/E* and 1/G* are zero
};

// Constants of a pair of materials. Two rigid ones have an infinite E*: scenes refuse them where they can meet, except by
// the linear law, which needs no modulus. shear_ratio is sqrt(St/Sn) = 2 sqrt(G*/E*), of the linear law sqrt(kt/kn); 0
// without damping of slip (model.slip_damping = false).
struct ContactLaw {
  double modulus = 0;        // Pa, E*
  double shear_modulus = 0;  // Pa, G*
  double viscosity = 0;      // -, 2 sqrt(5/6) beta; 2 beta of the linear law
  double shear_ratio = 0;    // -, Ct/Cn, of what beta gives of both
  double friction = 0;       // -, mu
  double rolling = 0;        // -, mu_r
  double floor = 0;          // N, least normal force: 0, or -infinity if the contact may pull
  ContactOptions options{};  // what is not of this law
};

inline double compliance(const Elastic& e) { return e.rigid ? 0 : (1 - e.poisson * e.poisson) / e.young; }

inline double shear_compliance(const Elastic& e) {
  return e.rigid ? 0 : (2 - e.poisson) * 2 * (1 + e.poisson) / e.young;  // G = E / (2 (1 + nu))
}

inline ContactLaw contact_law(const Elastic& i, const Elastic& j, double beta, double mu, double mu_rolling) {
  ContactLaw law;
  law.modulus = 1 / (compliance(i) + compliance(j));
  law.shear_modulus = 1 / (shear_compliance(i) + shear_compliance(j));
  law.viscosity = 2 * std::sqrt(5.0 / 6.0) * beta;
  law.shear_ratio = 2 * std::sqrt(law.shear_modulus / law.modulus);
  law.friction = mu;
  law.rolling = mu_rolling;
  return law;
}

inline void let_pull(ContactLaw& law) { law.floor = -infinity; }

// One touching contact as the law sees it.
struct Touch {
  double overlap;         // m, d >= 0
  double approach;        // m/s, d'
  double slip;            // m/s, vt: of the two surfaces at the contact, spin included
  double spring;          // m, xi: displacement of the tangential spring
  double spin;            // rad/s, w = omega_i - omega_j
  double reduced_radius;  // m, R*
  double reduced_mass;    // kg, m*
  // Of a rolling spring alone, see physics/rolling_spring.h:
  double turn = 0;             // rad, theta: displacement of the rolling spring
  double rolling_inertia = 0;  // kg m^2, Ir
};

struct TouchForce {
  double elastic;          // N, Fe
  double normal;           // N, Fn, repulsive if positive
  double tangential;       // N, Ft on body i, along the tangent
  double moment;           // N m, M on body i
  double stiffness;        // N/m, Sn
  double shear_stiffness;  // N/m, St: tangential stiffness
  double shear_viscosity;  // N s/m, Ct: factor of vt in Ft
};

// How stiff the contact is, and its elastic force.
[[gnu::always_inline]] inline void stiffen(const ContactLaw& law, const Touch& c, TouchForce& f) {
  const double root = std::sqrt(c.reduced_radius * c.overlap);
  f.stiffness = 2 * law.modulus * root;
  f.shear_stiffness = 8 * law.shear_modulus * root;
  f.elastic = (2.0 / 3.0) * f.stiffness * c.overlap;
}

// N s/m: what beta gives of Cn, 2 sqrt(5/6) beta sqrt(Sn m*); of the linear law 2 beta sqrt(kn m*).
[[gnu::always_inline]] inline double viscosity_of_factor(const ContactLaw& law, const Touch& c, const TouchForce& f) {
  return law.viscosity * std::sqrt(f.stiffness * c.reduced_mass);
}

// The normal part of the law, and the tangential stiffness: what does not depend on slip, spring and spin.
[[gnu::always_inline]] inline void press(const ContactLaw& law, const Touch& c, TouchForce& f) {
  stiffen(law, c, f);
  const double viscosity = viscosity_of_factor(law, c, f);
  f.shear_viscosity = viscosity * law.shear_ratio;

  const double push = f.elastic + viscosity * c.approach;
  f.normal = push > law.floor ? push : law.floor;
}

// N: the greatest tangential force.
[[gnu::always_inline]] inline double coulomb_limit(const ContactLaw& law, const TouchForce& f) {
  return law.friction * (f.normal > 0 ? f.normal : 0);
}

// m: |xi| is at most mu Fn / St. At d = 0, where nothing is stiff, it stays as it is.
[[gnu::always_inline]] inline double returned_spring(double limit, const TouchForce& f, double spring) {
  const double reach = limit / f.shear_stiffness;
  return spring > reach ? reach : spring < -reach ? -reach : spring;
}

// N, on body i along the tangent.
[[gnu::always_inline]] inline double tangential_force(const Touch& c, const TouchForce& f, double limit) {
  const double stick = -f.shear_stiffness * c.spring - f.shear_viscosity * c.slip;
  const double capped = stick > limit ? limit : stick;
  return capped < -limit ? -limit : capped;
}

// N m, on body i. It holds no disc at rest on a slope. With slope angle alpha, Fn = m g cos(alpha) and
// q = arm tan(alpha)/(mu_r R*), the moments arm m g sin(alpha) and |M| balance at
//
//   w = w0 q/sqrt(1 - q^2)    rad/s, for q < 1 and tan(alpha) <= mu: the disc rolls down steadily, with speed arm w
//
// From q = 1 on it accelerates.
[[gnu::always_inline]] inline double rolling_moment(const ContactLaw& law, const Touch& c, double normal,
                                                    double rolling_smoothing) {
  const double pressed = normal > 0 ? normal : 0;
  return -law.rolling * c.reduced_radius * pressed * c.spin /
         std::sqrt(c.spin * c.spin + rolling_smoothing * rolling_smoothing);
}

// N m s: -dM/dw at this normal force (N).
inline double rolling_viscosity(const ContactLaw& law, const Touch& c, double normal, double rolling_smoothing) {
  const double pressed = normal > 0 ? normal : 0;
  const double w0 = rolling_smoothing, root = std::sqrt(c.spin * c.spin + w0 * w0);
  return law.rolling * c.reduced_radius * pressed * w0 * w0 / (root * root * root);
}

// The law above, without options. rolling_smoothing: rad/s, w0.
inline TouchForce hertz_mindlin(const ContactLaw& law, const Touch& c, double rolling_smoothing) {
  TouchForce f{};
  press(law, c, f);
  f.tangential = tangential_force(c, f, coulomb_limit(law, f));
  f.moment = law.rolling > 0 ? rolling_moment(law, c, f.normal, rolling_smoothing) : 0;
  return f;
}

// W: the rates at which one contact dissipates mechanical energy, by cause; `stiffening` is supplied instead. The
// tangential spring stores 1/2 St xi^2, and St grows with sqrt(d):
//
//   d/dt (1/2 St xi^2) = St xi vt + 1/4 xi^2 St d'/d
//
// No force supplies the second term: it is booked as `stiffening`, negative while d shrinks. Rescaled and rolling springs
// have terms of their own (rescaled_mindlin.h, rolling_spring.h).
//
// `sliding` may be negative between jumps: within a step |xi| passes its limit, and the spring stores more than -Ft vt. The
// next jump books what it stores beyond the limit as heat. Signs of the ledger, and the balance: system/layout.h.
struct TouchPowers {
  double viscous;     // W, lost by the normal damper
  double sticking;    // W, lost by the tangential damper, while the contact sticks
  double sliding;     // W, lost by friction while it slides: -Ft vt minus St xi vt, stored in the spring
  double rolling;     // W, lost by rolling friction
  double stiffening;  // W, supplied to the springs as their stiffness changes
};

[[gnu::always_inline]] inline TouchPowers touch_powers(const Touch& c, const TouchForce& f) {
  const double stick = -f.shear_stiffness * c.spring - f.shear_viscosity * c.slip;
  const double lost = -f.tangential * c.slip - f.shear_stiffness * c.spring * c.slip;
  const bool sticks = stick == f.tangential;
  const double rate = 0.25 * c.spring * c.spring * f.shear_stiffness * c.approach / c.overlap;
  return {(f.normal - f.elastic) * c.approach, sticks ? lost : 0, sticks ? 0 : lost, -f.moment * c.spin,
          c.overlap > 0 ? rate : 0};  // two discs exactly at touch have none
}

// Their sums over contacts: viscous with sticking, friction of sliding.
struct ContactPowers {
  double viscous = 0, friction = 0, rolling = 0, stiffening = 0;  // W

  void add(const TouchPowers& one, bool scene_has_friction) {
    viscous += scene_has_friction ? one.viscous + one.sticking : one.viscous;
    if (!scene_has_friction) return;
    friction += one.sliding;
    rolling += one.rolling;
    stiffening += one.stiffening;
  }
  void add(const ContactPowers& others) {
    viscous += others.viscous;
    friction += others.friction;
    rolling += others.rolling;
    stiffening += others.stiffening;
  }
};

// J, stored in the normal spring of Hertz: the integral of Fe (N) from 0 to d (m), from both. By law, and from d alone:
// elastic_energy() of physics/impact.h.
inline double elastic_energy(double elastic, double overlap) { return 0.4 * elastic * overlap; }

}  // namespace furrow
