#include "scene/strip.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "scene/stem.h"

namespace furrow {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

// One spacing of the strip: columns of springs along it, cells between them.
struct Springs {
  Vector along;                   // N/m, of each column, bending links counted as 4: they stretch twice as far
  double diagonal, across, over;  // N/m; over: to the next but one across
  double tear_along;              // -, strain
  double tear_diagonal;           // -, stretch of a diagonal over s/sqrt(2)
};

double strain_at_tear(double strength, double stiffness, double per_strain) {
  return stiffness > 0 ? strength / (stiffness * per_strain) : infinity;
}

Springs springs_in(const Lattice& l, int columns) {
  const double s = l.spacing;
  if (l.stem) {
    const StemSprings k = springs_of(*l.stem, l);
    Springs stem{Vector::Constant(columns, k.inner), k.diagonal, k.across, 0, k.tear_strain, 2 * k.tear_strain};
    stem.along[0] = stem.along[columns - 1] = k.edge;
    return stem;
  }
  return {Vector::Constant(columns, l.structural.stiffness + 4 * l.bending.stiffness),
          l.shear.stiffness,
          l.structural.stiffness,
          columns > 2 ? l.bending.stiffness : 0,
          std::min(strain_at_tear(l.structural.strength, l.structural.stiffness, s),
                   strain_at_tear(l.bending.strength, l.bending.stiffness, 2 * s)),
          strain_at_tear(l.shear.strength, l.shear.stiffness, s / std::sqrt(2.0))};
}

// How much each cell grows across, over s, under the strain at the cells' middles: what costs least,
//   k_d (e + w)^2 + k_h w^2 in each cell, k_o (w + w')^2 of two neighbours.
Vector growth(const Springs& k, const Vector& strain) {
  const Eigen::Index cells = strain.size();
  Matrix m = (k.diagonal + k.across) * Matrix::Identity(cells, cells);
  for (Eigen::Index c = 0; c + 1 < cells; ++c) m.block<2, 2>(c, c).array() += k.over;
  if (k.diagonal == 0) return Vector::Zero(cells);
  return m.llt().solve(-k.diagonal * strain);
}

// N, over s: the stiffness against the pattern of strains e at the columns.
double stiffness(const Springs& k, const Vector& strain, Vector& width) {
  const Eigen::Index cells = strain.size() - 1;
  const Vector middle = 0.5 * (strain.head(cells) + strain.tail(cells));
  width = growth(k, middle);
  return strain.cwiseAbs2().dot(k.along) + k.diagonal * middle.dot(middle + width);
}

// The multiple of the pattern at which a link tears. Diagonals feel e + w.
double tearing(const Springs& k, const Vector& strain, const Vector& width) {
  const Eigen::Index cells = width.size();
  const Vector middle = 0.5 * (strain.head(cells) + strain.tail(cells));
  return std::min(k.tear_along / strain.maxCoeff(), k.tear_diagonal / (middle + width).maxCoeff());
}

bool has(const std::vector<int>& list, int line) { return std::find(list.begin(), list.end(), line) != list.end(); }

// m, from the line nearest to the middle that is held together with all lines beyond it.
double free_length(const std::vector<int>& fixed, int lines, double spacing) {
  int below = 0, above = 0;
  while (below < lines && has(fixed, below)) ++below;
  while (above < lines && has(fixed, lines - 1 - above)) ++above;
  const int held = std::max(below, above);
  return spacing * std::max(1, lines - std::max(1, held));
}

}  // namespace

double Beam::diameter() const { return 4 * std::sqrt(bending / tension); }
double Beam::young() const { return 4 * tension / (pi * diameter() * diameter()); }
double Beam::tip_compliance() const { return length * length * length / (3 * bending) + length / shear; }
double Beam::first_frequency() const {
  const double wave = first_bending / length;
  return wave * wave * std::sqrt(bending / mass) / (2 * pi);
}

std::optional<Beam> beam_of(const Lattice& l) {
  const bool upright = l.rows >= l.columns;
  const int columns = upright ? l.columns : l.rows, lines = upright ? l.rows : l.columns;
  if (columns < 2) return {};
  const double s = l.spacing, cells = columns - 1;
  const Springs k = springs_in(l, columns);
  const Vector uniform = Vector::Ones(columns);
  const Vector linear = Vector::LinSpaced(columns, -0.5 * cells * s, 0.5 * cells * s);  // m
  Vector narrowing, width;
  Beam b{};
  b.tension = s * stiffness(k, uniform, narrowing);
  b.bending = s * stiffness(k, linear, width);
  if (!(b.tension > 0 && b.bending > 0)) return {};
  b.shear = s * cells * k.diagonal;
  b.poisson = -narrowing.mean();
  b.mass = l.node_mass * (l.stem ? cells : columns) / s;
  b.held = !(upright ? l.fixed_rows : l.fixed_columns).empty();
  b.length = free_length(upright ? l.fixed_rows : l.fixed_columns, lines, s);
  b.isotropic = !l.stem && std::fabs(2 * k.diagonal - k.along[0]) <= 1e-12 * k.along[0];
  b.tearing_strain = tearing(k, uniform, narrowing);
  b.tearing_curvature = tearing(k, linear, width);
  return b;
}

}  // namespace furrow
