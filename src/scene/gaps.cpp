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

// The plate's range across its way, along which it goes in time.end from `from` to `to`.
struct Track {
  bool along_x;
  double low, high, from, to;  // m
};

Track track_of(const Plate& p, double end) {
  const bool along_x = std::fabs(p.velocity.x) >= std::fabs(p.velocity.y);
  const double left = p.left_edge, lower = *p.lower_edge;
  const double begin = along_x ? left : lower, length = along_x ? p.width : p.height;
  const double way = (along_x ? p.velocity.x : p.velocity.y) * end;
  const double low = along_x ? lower : left, side = along_x ? p.height : p.width;
  return {along_x, low, low + side, std::min(begin, begin + way), std::max(begin, begin + way) + length};
}

// A plate that moves meets nodes with the side across its way. It passes between two of them where it comes to a lattice
// and none is within that side.
std::string fits_between(const Plate& p, const Lattice& l, double end, const std::string& path) {
  if (!p.lower_edge || (p.velocity.x == 0 && p.velocity.y == 0)) return {};  // its place is known when the bed is
  const Track track = track_of(p, end);
  const double side = track.high - track.low, slack = touch * side;
  if (!(side < (1 - touch) * l.spacing)) return {};
  bool below = false, above = false;
  const StandingLattice here(l);
  for (const Vec2 node : here.nodes()) {
    const double across = track.along_x ? node.y : node.x, along = track.along_x ? node.x : node.y;
    if (along < track.from || along > track.to) continue;  // it never comes there
    if (across >= track.low - slack && across <= track.high + slack) return {};
    (across < track.low ? below : above) = true;
  }
  if (!below || !above) return {};
  return std::string("its ") + (track.along_x ? "height, " : "width, ") + rounded(side, 3) +
         " m, is less than the spacing of " + path + ", " + rounded(l.spacing, 3) +
         " m, and no node stands over against it: plates meet nodes alone, so it can pass between two of them";
}

}  // namespace

double half_gap(const Lattice& l) {
  return l.auxiliary_points == 0 ? 0 : StandingLattice(l).longest_segment() / (l.auxiliary_points + 1) / 2;
}

std::string way_through(const Lattice& l, double radius) {
  if (l.rows * l.columns < 2) return {};
  const double half = half_gap(l), longest = 2 * half * (l.auxiliary_points + 1);
  if (!(radius < (1 - touch) * half)) return {};
  constexpr double most = 1000;  // points that a segment may have
  const double needed = std::ceil((1 - touch) * longest / (2 * radius)) - 1;
  return "discs of radius " + rounded(radius, 3) + " m pass between the points of its border, which are " +
         (longest > (1 + touch) * l.spacing ? "up to " : "") + rounded(2 * half, 3) + " m apart: take " +
         (needed <= most ? "at least " + rounded(needed, 4) + " points, or " : "") + "0, the whole border";
}

void judge_gaps(const Scene& scene, Findings& found) {
  if (!found.sound()) return;
  const double radius = smallest_disc(scene);
  for (std::size_t k = 0; k < scene.lattice.size(); ++k) {
    const Lattice& l = scene.lattice[k];
    const std::string path = item("lattice", k);
    if (const std::string through = way_through(l, radius); !through.empty())
      found.warning(path + ".auxiliary_points", through);
    for (std::size_t j = 0; j < scene.plate.size(); ++j)
      if (const std::string fits = fits_between(scene.plate[j], l, scene.time.end, path); !fits.empty())
        found.warning(item("plate", j), fits);
  }
}

}  // namespace furrow
