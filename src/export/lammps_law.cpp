#include "export/lammps_law.h"

#include <cmath>

#include "scene/wording.h"

namespace furrow {
namespace {

double polynomial(double e) {
  return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

bool linear(const ContactLaw& law) { return law.options.force == ForceLaw::linear; }

std::string words(std::initializer_list<std::string> all) { return joined(all, " "); }

// What the factor of vt is of that of d'.
double tangential_ratio(const ContactLaw& law) {
  if (law.options.dashpot > 0) return law.options.tangential_dashpot / law.options.dashpot;
  return law.viscosity > 0 ? law.shear_ratio : 0;
}

std::string tangent(const ContactLaw& law, double scale) {
  if (!(law.friction > 0)) return "linear_nohistory 0 0";
  const std::string kind = linear(law)                                       ? "linear_history"
                           : law.options.force == ForceLaw::rescaled_mindlin ? "mindlin_rescale/force"
                                                                             : "mindlin";
  const double stiffness = linear(law) ? law.options.tangential_stiffness : 8 * law.shear_modulus * scale;
  return words({kind, shortest(stiffness), shortest(tangential_ratio(law)), shortest(law.friction)});
}

std::string rest_of(const ContactLaw& law, const RollingWords& rolling, const std::string& damping) {
  std::string text;
  if (law.rolling > 0)
    text += words({" rolling sds", shortest(rolling.stiffness), shortest(rolling.damping), shortest(law.rolling)});
  text += " damping " + damping;
  // Fe alone never pulls.
  const bool damped = law.viscosity > 0 || law.options.dashpot > 0;
  return text + (damped && law.floor == 0 ? " limit_damping" : "");
}

}  // namespace

double tsuji_number(double alpha) {
  double low = -1, high = 1.01;  // the polynomial falls between them, and is negative at the latter
  while (polynomial(low) < alpha) low *= 2;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (polynomial(middle) > alpha ? low : high) = middle;
  }
  return low;
}

double tsuji_alpha(const ContactLaw& law) { return linear(law) ? law.viscosity : std::sqrt(1.5) * law.viscosity; }

LammpsLaw lammps_law(const ContactLaw& law, double ratio, const RollingWords& rolling) {
  const double scale = linear(law) ? 1 : std::sqrt(ratio);
  const double stiffness = linear(law) ? law.options.normal_stiffness : 4.0 / 3.0 * law.modulus * scale;
  const auto with = [&](double number, const std::string& damping) {
    return words({linear(law) ? "hooke" : "hertz", shortest(stiffness), shortest(number), "tangential"}) + " " +
           tangent(law, scale) + rest_of(law, rolling, damping);
  };
  if (!(law.viscosity > 0)) {
    const std::string same = with(law.options.dashpot, "velocity");
    return {same, same, 0};
  }
  const double number = tsuji_number(tsuji_alpha(law));
  const double beta = tsuji_alpha(law) / (linear(law) ? 2 : std::sqrt(5.0));
  LammpsLaw both{with(number, "tsuji"), {}, number};
  if (beta < 1) both.restitution = with(std::exp(-pi * beta / std::sqrt(1 - beta * beta)), "coeff_restitution");
  return both;
}

}  // namespace furrow
