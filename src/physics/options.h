// What a contact may have beyond the law of Hertz and Mindlin (physics/contact.h). Where every option is at its
// default that law holds as it stands there, and the kernel runs it in vectors.
//
//   force        another law: linear.h, rescaled_mindlin.h
//   dashpot      damping besides that of beta, or in its place: damping.h
//   after_slip   what a tangential spring holds after it has slipped: damping.h
//   rolling      a rolling spring: rolling_spring.h
//
// One more law takes
//
//   physics/    a header with its stiffnesses, elastic force, stored energy, powers and impact, as linear.h has them;
//               here its name, and whether its stiffness is constant; contact_force.h, whose switches call it;
//               rolling_spring.h, whose stiffness grows with Sn; impact.h, which knows two springs: a constant stiffness
//               is the linear law's, any other is Hertz's, so a third spring has to be named there
//   who asks    is_linear() of impact.h, by grep: run/events.cpp, system/survey.cpp, program/explain.cpp and
//               explain_law.cpp
//   system/     laws.cpp: its constants, from a scene
//   scene/      schema.h: its key; validate.cpp and effects.cpp: what it needs and ignores; damping.cpp
//   the others  program/explain_law.cpp: its words; export/deck.cpp, lammps_law.cpp and deviations.cpp: its name elsewhere
//
// The kernel takes it from contact_force.h. What every law shares, and a law with adhesion (JKR) would have to change:
// two bodies touch where they overlap, d > 0; a contact without overlap has no stiffness of its own; friction is limited
// by mu max(0, Fn); and the terms 1/4 (...) d'/d of the ledger are of stiffnesses that grow with sqrt(d).
#pragma once

namespace furrow {

enum class ForceLaw { hertz_mindlin, rescaled_mindlin, linear };

// A switch over the laws names each of them, without a default. So with warnings as errors (FURROW_WERROR) one more does not
// compile until all of them say what they do.
constexpr bool has_constant_stiffness(ForceLaw law) {
  switch (law) {
    case ForceLaw::hertz_mindlin:
    case ForceLaw::rescaled_mindlin:
      return false;
    case ForceLaw::linear:
      return true;
  }
  return false;
}

enum class AfterSlip { elastic, less_viscous };
enum class Rolling { none, smoothed, spring };

// Of a pair of materials.
struct ContactOptions {
  ForceLaw force = ForceLaw::hertz_mindlin;
  AfterSlip after_slip = AfterSlip::elastic;
  bool rolling_spring = false;
  double normal_stiffness = 0;      // N/m, kn of the linear law
  double tangential_stiffness = 0;  // N/m, kt of the linear law
  double dashpot = 0;               // N s/m, cn of any law
  double tangential_dashpot = 0;    // N s/m, ct of any law
  double rolling_stiffness = 0;     // N m, kr; 0: it follows the normal stiffness
  double rolling_damping = 0;       // -, eta_r

  bool none() const {
    return force == ForceLaw::hertz_mindlin && after_slip == AfterSlip::elastic && !rolling_spring && dashpot == 0 &&
           tangential_dashpot == 0;
  }
};

}  // namespace furrow
