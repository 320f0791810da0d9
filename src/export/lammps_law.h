// A contact law in the words of LAMMPS: pair style granular, and walls of that style.
//
//   hertz KN E tangential mindlin KT X MU damping tsuji
//     a  = sqrt(R* d)
//     Fn = KN a d + alpha(E) sqrt(KN a m*) d'      KN = 4/3 E*
//     Ft = -KT a xi - X alpha(E) sqrt(KN a m*) vt  KT = 8 G*
//   hooke KN E tangential linear_history KT X MU damping tsuji
//     a  = 1 in the three places
//   damping velocity: E and X E in place of the two factors of d' and vt
//
// E is called a restitution there, but is only the argument of a polynomial of Tsuji, Tanaka and Ishida 1992:
//
//   alpha(E) = 1.2728 - 4.2783 E + 11.087 E^2 - 22.348 E^3 + 27.467 E^4 - 18.022 E^5 + 4.8218 E^6
//
// so it is solved for the alpha that is wanted. Above 1.2728 (beta > 0.569) it is negative, which versions before
// 28 Mar 2023 take and later ones do not. From 17 Apr 2024 on `damping coeff_restitution` has the alpha of furrow's
// restitution e = exp(-pi beta/sqrt(1 - beta^2)), for beta < 1.
#pragma once

#include <optional>
#include <string>

#include "physics/contact.h"

namespace furrow {

// E with alpha(E) = alpha; 1.0007 where there is no damping.
double tsuji_number(double alpha);

// alpha: -, of the viscous force, sqrt(5) beta of Hertz's law and 2 beta of the linear one.
double tsuji_alpha(const ContactLaw& law);

struct RollingWords {
  double stiffness = 0, damping = 0;  // N/m, N s/m, of the pseudo-force of `rolling sds`
};

struct LammpsLaw {
  std::string tsuji;                         // for versions before 28 Mar 2023; before 17 Apr 2024 if `number` >= 0
  std::optional<std::string> restitution{};  // for versions from 17 Apr 2024 on; none: they cannot damp so much
  double number = 0;                         // E of Tsuji's polynomial
};

// `ratio`: -, R* of the law over that of the sphere that stands for it: 1, but for nodes of lattices.
LammpsLaw lammps_law(const ContactLaw& law, double ratio = 1, const RollingWords& rolling = {});

}  // namespace furrow
