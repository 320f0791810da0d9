#include "scene/stem.h"

#include <algorithm>
#include <cmath>

namespace furrow {
namespace {

constexpr double most_rows = 1e5;

double area(const Stem& s) { return pi * s.diameter * s.diameter / 4; }                 // m^2
double second_moment(const Stem& s) { return area(s) * s.diameter * s.diameter / 16; }  // m^4
double bending_rate(const Stem& s, double density) {                                    // rad/s
  const double wave = first_bending / s.length;
  return wave * wave * std::sqrt(s.young * second_moment(s) / (density * area(s)));
}

double density_of(const std::vector<Material>& materials, const std::string& name) {
  for (const Material& m : materials)
    if (m.name == name) return m.density;
  return Material{}.density;
}

void fill(const Stem& stem, double density, Lattice& l) {
  const double cells = std::max(1, l.columns - 1);
  const double layers = std::round(stem.length * cells / stem.diameter);
  l.rows = 1 + static_cast<int>(layers >= 1 ? std::min(layers, most_rows) : 1);
  l.spacing = stem.length / (l.rows - 1);
  l.node_mass = density * area(stem) * l.spacing / cells;
}

}  // namespace

StemSprings springs_of(const Stem& stem, const Lattice& l) {
  const double c = l.columns - 1, s = l.spacing;
  const double shear = stem.young / (2 * (1 + stem.poisson));  // Pa
  StemSprings k{};
  k.diagonal = shear * area(stem) / (c * s);
  k.across = k.diagonal * (1 - stem.poisson) / stem.poisson;
  const double cell = k.diagonal * (1 - stem.poisson);
  const double sum = stem.young * area(stem) / s - c * cell;                                           // of k_j
  const double spread = stem.young * second_moment(stem) / (s * s * s) - cell * c * (c * c - 1) / 12;  // of k_j x_j^2
  const double between = c * (c - 2) / 12;  // mean of x_j^2 of the columns between
  k.edge = (spread - sum * between) / (c * c / 2 - 2 * between);
  k.inner = (sum - 2 * k.edge) / (c - 1);
  const double density = l.node_mass * c / (area(stem) * s);
  k.relaxation = 2 * stem.damping_ratio / bending_rate(stem, density);
  k.tear_strain = stem.strength / stem.young;
  return k;
}

bool has_springs(const Stem& stem, const Lattice& l) {
  const StemSprings k = springs_of(stem, l);
  return k.edge > 0 && k.inner > 0;
}

void fill_stems(std::vector<Lattice>& lattices, const std::vector<Material>& materials) {
  for (Lattice& l : lattices)
    if (l.stem) fill(*l.stem, density_of(materials, l.material), l);
}

}  // namespace furrow
