#include "program/explain_law.h"

#include <cmath>

#include "physics/impact.h"
#include "program/explain_line.h"

namespace furrow {
namespace {

const char* name_of(ForceLaw law) {
  switch (law) {
    case ForceLaw::rescaled_mindlin:
      return "Hertz and Mindlin; the tangential force shrinks with the contact as it unloads (Thornton)";
    case ForceLaw::linear:
      return "linear springs (Cundall and Strack)";
    case ForceLaw::hertz_mindlin:
      break;
  }
  return "Hertz and Mindlin, without slip at the edge of the contact";
}

const char* name_of(MomentArm arm) {
  switch (arm) {
    case MomentArm::half_overlap:
      return "R - d/2 of all contacts";
    case MomentArm::radius:
      return "R";
    case MomentArm::contact_point:
      break;
  }
  return "to the contact point: R - d/2 between discs, R - d elsewhere";
}

const char* name_of(Rolling rolling) {
  switch (rolling) {
    case Rolling::spring:
      return "a spring up to the limit (Ai et al. 2011, type C): holds a disc on a slope below atan(mu_r)";
    case Rolling::none:
      return "not resisted (model.rolling = \"none\")";
    case Rolling::smoothed:
      break;
  }
  return "a moment that fades at small spins";
}

double restitution_of(double beta) { return beta < 1 ? std::exp(-pi * beta / std::sqrt(1 - beta * beta)) : 0; }

void print_damping(const ContactLaw& law) {
  if (law.options.dashpot > 0 || law.options.tangential_dashpot > 0)
    return line("", "damping %.6g N s/m along the normal, %.6g N s/m along the tangent", law.options.dashpot,
                law.options.tangential_dashpot);
  const double ratio = law.viscosity / 2;  // c / (2 sqrt(Sn m*)), at any overlap
  line("", "damping ratio %.4g at any overlap%s", ratio,
       ratio > 1 ? ": beyond critical, a contact does not bounce but creeps back" : "");
  const double beta = damping_ratio_of_impact(law);
  if (is_linear(law)) return line("", "that is restitution %.4g", restitution_of(beta));
  line("", "that is damping_factor %.4g, tsuji_alpha %.4g, restitution %.4g", beta, std::sqrt(5.0) * beta,
       restitution_of(beta));
}

}  // namespace

void print_options(const Scene& scene, const Parts& parts) {
  line("law of contacts", "%s", name_of(scene.model.law));
  if (parts.disc.count() > 0) {
    if (parts.friction) line("moment arm", "%s", name_of(scene.model.moment_arm));
    if (parts.rolling || scene.model.rolling == Rolling::none) line("rolling", "%s", name_of(scene.model.rolling));
  }
  if (parts.friction && !scene.model.slip_damping) line("damping of slip", "none (model.slip_damping = false)");
  if (parts.friction)
    line("springs after slip", "hold the Coulomb limit%s",
         scene.model.after_slip == AfterSlip::less_viscous ? " less the viscous force, as in LAMMPS" : "");
  if (parts.friction && scene.model.after_slip == AfterSlip::less_viscous && scene.output.energy &&
      !has_constant_stiffness(scene.model.law))
    line("",
         "so the energy ledger does not close, at any step: the spring of a contact that begins by sliding has no "
         "bound");
  for (const Plate& p : scene.plate)
    if (p.ramp > 0)
      line("plate " + p.name, "reaches its speed in %g s", p.ramp);
    else if (p.velocity != Vec2{})
      line("plate " + p.name, "ramp: none, full speed at once");
}

void print_law(const std::string& pair, const ContactLaw& law) {
  const ContactOptions& o = law.options;
  if (is_linear(law))
    line(pair, "kn = %.6g N/m, kt = %.6g N/m, friction %g, rolling %g", o.normal_stiffness, o.tangential_stiffness,
         law.friction, law.rolling);
  else
    line(pair, "E* = %.6g Pa, G* = %.6g Pa, friction %g, rolling %g", law.modulus, law.shear_modulus, law.friction,
         law.rolling);
  print_damping(law);
  if (!rolls_on_spring(law)) return;
  if (o.rolling_stiffness > 0)
    line("", "rolling spring %.6g N m, damped by %g of critical", o.rolling_stiffness, o.rolling_damping);
  else
    line("", "rolling spring 3 Sn mu_r^2 R*^2, damped by %g of critical", o.rolling_damping);
}

}  // namespace furrow
