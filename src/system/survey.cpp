#include "system/survey.h"

#include <algorithm>
#include <cmath>

#include "system/kernel.h"
#include "system/system.h"

namespace furrow {
namespace {

double narrow(const PlatePart& p) { return std::min(p.width, p.height); }

ContactId id_of(const TouchBlock& c, int k) { return {c.kind, c.a[k], c.b[k]}; }

double size_of(const Parts& parts, const TouchBlock& c, int k) {
  if (!of_disc(c.kind)) return parts.node.contact_radius[c.a[k]];
  return c.kind == disc_disc ? std::min(c.radius_a[k], c.radius_b[k]) : c.radius_a[k];
}

// Blocks of plates and lattices hold few contacts, and only those that touch.
BlockExtremes few_extremes(const Parts& parts, const TouchBlock& c) {
  BlockExtremes all{static_cast<double>(c.count), 0, 0};
  for (int k = 0; k < c.count; ++k) {
    all.overlap = std::max(all.overlap, c.overlap[k] / size_of(parts, c, k));
    all.approach = std::max(all.approach, c.vx[k] * c.nx[k] + c.vy[k] * c.ny[k]);
  }
  return all;
}

void find_deepest(const Parts& parts, const TouchBlock& c, ContactExtremes& seen) {
  for (int k = 0; k < c.count; ++k) {
    if (c.touching[k] != 0 && c.overlap[k] / size_of(parts, c, k) == seen.overlap) seen.deepest = id_of(c, k);
  }
}

void find_hardest(const Parts& parts, const TouchBlock& c, ContactExtremes& seen) {
  for (int k = 0; k < c.count; ++k) {
    const double approach = c.vx[k] * c.nx[k] + c.vy[k] * c.ny[k];
    if (c.touching[k] == 0 || !(approach > 0)) continue;
    const ContactLaw& law = parts.law[c.law[k]];
    const double left = approach * impact_factor(law);  // m/s, of which the damping will not have taken all
    const double energy =
        0.5 * c.reduced_mass[k] * left * left + elastic_energy(law, c.reduced_radius[k], c.overlap[k]);
    const double impact = energy / passing_work(parts, id_of(c, k), law, c.reduced_radius[k]);
    if (!(impact > seen.impact)) continue;
    seen.impact = impact;
    seen.hardest = id_of(c, k);
  }
}

}  // namespace

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
      return elastic_energy(law, reduced_radius, radius + 0.5 * narrow(parts.plate[contact.b]));
    case disc_lattice:
      return elastic_energy(law, reduced_radius, radius);
    case disc_wall:
    case node_wall:
      break;
  }
  return infinity;
}

// Of two equal discs, E its work and v its speed: a plate or border takes no less than E / 4 for no more than twice the
// reduced mass, v / sqrt(8); a larger partner no less than E for no more than twice the mass.
double least_passing_speed(const Parts& parts) {
  double modulus = infinity;
  for (const ContactLaw& law : parts.law) modulus = std::min(modulus, law.modulus);
  if (std::isinf(modulus)) return infinity;
  const ContactLaw softest{.modulus = modulus};
  double least = infinity;  // squared
  for (int i = 0; i < parts.disc.count(); ++i) {
    const double radius = parts.disc.radius[i];
    least = std::min(least, 2 * elastic_energy(softest, radius / 2, 2 * radius) / (parts.disc.mass[i] / 2) / 8);
  }
  for (const PlatePart& p : parts.plate) {
    for (int n = 0; n < parts.node.count(); ++n)
      least = std::min(least,
                       2 * elastic_energy(softest, parts.node.contact_radius[n], narrow(p) / 2) / parts.node.mass[n]);
  }
  return std::sqrt(least);
}

void System::survey_block(const TouchBlock& c, int chunk) {
  ContactExtremes& seen = chunk_seen_[chunk];
  const bool many = c.kind == disc_disc || c.kind == disc_wall;
  const BlockExtremes block = many ? extremes(c) : few_extremes(parts_, c);
  seen.contacts += block.contacts;
  if (block.overlap > seen.overlap) {
    seen.overlap = block.overlap;
    if (block.overlap > survey_.known_overlap) find_deepest(parts_, c, seen);
  }
  if (block.approach > survey_.fast) find_hardest(parts_, c, seen);
  if (c.kind == disc_wall) {
    if (block.overlap > 1) {
      for (int k = 0; k < c.count; ++k) seen.behind_walls += c.overlap[k] > c.radius_a[k] ? 1 : 0;
    }
  } else if (!many) {
    survey_few(c);
  }
}

// What presses on plates, and who is about to pass through something.
void System::survey_few(const TouchBlock& c) {
  const bool plates = c.kind == disc_plate || c.kind == node_plate;
  for (int k = 0; k < c.count; ++k) {
    if (plates) {
      survey_.plate_fx[c.b[k]] -= c.force_x(k);
      survey_.plate_fy[c.b[k]] -= c.force_y(k);
    }
    const bool near = plates ? c.overlap[k] > c.radius_a[k] : near_border(c, k);
    if (near) survey_.near.push_back({id_of(c, k), plates ? -1 : c.segment[k]});
  }
}

// Between two auxiliary points a centre passes at some distance from either.
bool System::near_border(const TouchBlock& c, int k) const {
  if (c.kind != disc_lattice) return false;
  const double spacing = parts_.node.spacing[parts_.border.a[c.segment[k]]];
  const int auxiliary = parts_.lattice[c.b[k]].auxiliary_points;
  const double between = auxiliary > 0 ? spacing / (auxiliary + 1) : 0;
  return c.radius_a[k] - c.overlap[k] < survey_.reach + between;
}

void System::begin_survey() {
  std::fill(chunk_seen_.begin(), chunk_seen_.end(), ContactExtremes{});
  survey_.near.clear();
  survey_.plate_fx.assign(parts_.plate.size(), 0.0);
  survey_.plate_fy.assign(parts_.plate.size(), 0.0);
}

void System::finish_survey() {
  survey_.seen = {};
  for (const ContactExtremes& seen : chunk_seen_) survey_.seen.join(seen);
}

}  // namespace furrow
