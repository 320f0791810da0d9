#include "system/survey.h"

#include <algorithm>
#include <cmath>

#include "physics/impact.h"

namespace furrow {
namespace {

double narrow(const PlatePart& p) { return std::min(p.width, p.height); }

// m: what an overlap is compared with.
double size_of(const Parts& parts, const ContactId& pair) {
  if (!of_disc(pair.kind)) return parts.node.contact_radius[pair.a];
  const double a = parts.disc.radius[pair.a];
  return pair.kind == disc_disc ? std::min(a, parts.disc.radius[pair.b]) : a;
}

}  // namespace

void Survey::begin(const Parts& parts) {
  seen = {};
  near.clear();
  plate_fx.assign(parts.plate.size(), 0.0);
  plate_fy.assign(parts.plate.size(), 0.0);
}

void Survey::see(const Parts& parts, const Contact& c, ContactExtremes& sum) {
  ++sum.contacts;
  const double relative = c.touch.overlap / size_of(parts, c.id);
  if (relative > sum.overlap) {
    sum.overlap = relative;
    if (relative > known_overlap) sum.deepest = c.id;
  }
  see_impact(parts, c, sum);
  const double radius = of_disc(c.id.kind) ? parts.disc.radius[c.id.a] : 0;
  if (c.id.kind == disc_wall && c.touch.overlap > radius) ++sum.behind_walls;
  if (of_plate(c.id.kind)) {
    plate_fx[c.id.b] -= c.fx;
    plate_fy[c.id.b] -= c.fy;
    if (radius - c.touch.overlap < reach) near.push_back(c.id);
  }
}

void Survey::see_impact(const Parts& parts, const Contact& c, ContactExtremes& sum) const {
  if (!(c.touch.approach > fast)) return;
  const ContactLaw& law = parts.law[c.law];
  const double left = c.touch.approach * impact_factor(law);  // m/s, of which the damping will not have taken all
  const double energy =
      0.5 * c.touch.reduced_mass * left * left + elastic_energy(law, c.touch.reduced_radius, c.touch.overlap);
  const double impact = energy / passing_work(parts, c.id, law, c.touch.reduced_radius);
  if (!(impact > sum.impact)) return;
  sum.impact = impact;
  sum.hardest = c.id;
}

void ContactExtremes::join(const ContactExtremes& other) {
  contacts += other.contacts;
  behind_walls += other.behind_walls;
  if (other.overlap > overlap) overlap = other.overlap, deepest = other.deepest;
  if (other.impact > impact) impact = other.impact, hardest = other.hardest;
}

double passing_work(const Parts& parts, const ContactId& contact, const ContactLaw& law, double reduced_radius) {
  const double radius = of_disc(contact.kind) ? parts.disc.radius[contact.a] : 0;
  switch (contact.kind) {
    case disc_disc:
      return elastic_energy(law, reduced_radius, radius + parts.disc.radius[contact.b]);
    case disc_plate:
    case node_plate:
      if (parts.tight_plates) break;
      return elastic_energy(law, reduced_radius, radius + 0.5 * narrow(parts.plate[contact.b]));
    case disc_lattice:
      return elastic_energy(law, reduced_radius, radius);
    case disc_wall:
    case node_wall:
      break;
  }
  return infinity;
}

double stiffness_of(const ContactLaw& law) { return is_linear(law) ? law.options.normal_stiffness : law.modulus; }

ContactLaw softest_of(const Parts& parts) {
  ContactLaw softest{.modulus = infinity};
  for (const ContactLaw& law : parts.law)
    if (&law == parts.law.data() || stiffness_of(law) < stiffness_of(softest)) softest = law;
  return softest;
}

// Of two equal discs, E its work and v its speed: a plate or border takes no less than E / 4 for no more than twice the
// reduced mass, v / sqrt(8); a larger partner no less than E for no more than twice the mass.
double least_passing_speed(const Parts& parts) {
  const ContactLaw softest = softest_of(parts);
  if (!(stiffness_of(softest) < infinity)) return infinity;
  double least = infinity;  // squared
  for (int i = 0; i < parts.disc.count(); ++i) {
    const double radius = parts.disc.radius[i];
    least = std::min(least, 2 * elastic_energy(softest, radius / 2, 2 * radius) / (parts.disc.mass[i] / 2) / 8);
  }
  for (const PlatePart& p : parts.plate) {
    if (parts.tight_plates) break;
    for (int n = 0; n < parts.node.count(); ++n)
      least = std::min(least,
                       2 * elastic_energy(softest, parts.node.contact_radius[n], narrow(p) / 2) / parts.node.mass[n]);
  }
  return std::sqrt(least);
}

}  // namespace furrow
