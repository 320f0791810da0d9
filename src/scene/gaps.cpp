// The border of a lattice has gaps: discs touch points of it, plates its nodes. What is small enough passes between two.
#include "scene/gaps.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/border.h"
#include "scene/findings.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double touch = 1e-9;  // of a length: rounding

double smallest_disc(const Scene& scene) {
  double least = infinity;
  for (const Disc& d : scene.disc) least = std::fmin(least, d.radius);
  for (const Packing& p : scene.packing) least = std::fmin(least, p.radius_min);
  return least;
}

// Whether a node lies within the height (upright), or within the width of a plate.
bool stands_against(const Lattice& l, const Plate& p, bool upright) {
  const double side = upright ? p.height : p.width;
  const double from = (upright ? p.lower_edge.value_or(NAN) : p.left_edge) - touch * side;
  const StandingLattice here(l);
  return std::any_of(here.nodes().begin(), here.nodes().end(), [&](Vec2 node) {
    const double at = upright ? node.y : node.x;
    return at >= from && at <= from + (1 + 2 * touch) * side;
  });
}

// A plate meets nodes with the side across its way; one that stands, with either.
std::string fits_between(const Plate& p, const Lattice& l, const std::string& path) {
  const double along_x = std::fabs(p.velocity.x), along_y = std::fabs(p.velocity.y);
  const bool stands = along_x == 0 && along_y == 0;
  const bool upright = stands ? p.height < p.width : along_x >= along_y;
  const double side = upright ? p.height : p.width;
  if (!(side < (1 - touch) * l.spacing) || stands_against(l, p, upright)) return {};
  if (stands && stands_against(l, p, !upright)) return {};
  return std::string("its ") + (upright ? "height, " : "width, ") + rounded(side, 3) +
         " m, is less than the spacing of " + path + ", " + rounded(l.spacing, 3) +
         " m, and no node stands over against it: plates meet nodes alone, so it can pass between two of them";
}

}  // namespace

double half_gap(const Lattice& l) { return l.auxiliary_points == 0 ? 0 : l.spacing / (l.auxiliary_points + 1) / 2; }

std::string way_through(const Lattice& l, double radius) {
  if (!(radius < half_gap(l))) return {};
  constexpr double most = 1000;  // points that a segment may have
  const double needed = std::floor(l.spacing / (2 * radius));
  return "discs of radius " + rounded(radius, 3) + " m pass between the points of its border, which are " +
         rounded(2 * half_gap(l), 3) + " m apart: take " +
         (needed <= most ? "at least " + rounded(needed, 4) + " points, or " : "") + "0, the whole border";
}

void judge_gaps(const Scene& scene, Findings& found) {
  if (found.any_error()) return;
  const double radius = smallest_disc(scene);
  for (std::size_t k = 0; k < scene.lattice.size(); ++k) {
    const Lattice& l = scene.lattice[k];
    const std::string path = item("lattice", k);
    if (const std::string through = way_through(l, radius); !through.empty())
      found.warning(path + ".auxiliary_points", through);
    for (std::size_t j = 0; j < scene.plate.size(); ++j)
      if (const std::string fits = fits_between(scene.plate[j], l, path); !fits.empty())
        found.warning(item("plate", j), fits);
  }
}

}  // namespace furrow
