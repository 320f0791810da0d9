#include "kernel/size_classes.h"

#include <algorithm>
#include <cmath>

namespace furrow {
namespace {

// The fraction of its distance checks that a class must save to be split. Sizes spread evenly over a factor of 4 stay
// together: a second grid would cost as much. One large disc among many is a class of its own if its radius is more
// than 1.12 times theirs.
constexpr double worth_splitting = 0.2;

// The cells of a class are as large as its greatest disc, so n discs need about n * greatest^2 distance checks. Where
// to cut [first, last), ascending, to save the most checks; `last` if no cut saves enough.
std::size_t best_cut(const std::vector<double>& radius, std::size_t first, std::size_t last) {
  std::size_t best = last;
  double most = worth_splitting;
  for (std::size_t cut = first + 1; cut < last; ++cut) {
    const double share = static_cast<double>(cut - first) / static_cast<double>(last - first);
    const double size = radius[cut - 1] / radius[last - 1];
    const double spared = share * share * (1 - size * size);
    if (spared > most) {
      most = spared;
      best = cut;
    }
  }
  return best;
}

// Appends the greatest radii of the classes, ascending.
void cut(const std::vector<double>& radius, std::size_t first, std::size_t last, std::vector<double>& greatest) {
  const std::size_t at = best_cut(radius, first, last);
  if (at < last) cut(radius, first, at, greatest);
  if (at < last) return cut(radius, at, last, greatest);
  greatest.push_back(radius[last - 1]);
}

}  // namespace

SizeClasses::SizeClasses(std::vector<int> bodies, const std::vector<double>& radius) : bodies_(std::move(bodies)) {
  if (bodies_.empty()) return;
  const auto radius_of = [&](int i) { return radius.empty() ? 0 : radius[i]; };
  std::vector<double> sorted, greatest;
  for (const int i : bodies_) sorted.push_back(radius_of(i));
  std::sort(sorted.begin(), sorted.end());
  cut(sorted, 0, sorted.size(), greatest);
  for (const double r : greatest) classes_.push_back({r, {}, {}});
  class_of_.resize(static_cast<std::size_t>(bodies_.back()) + 1);
  for (const int i : bodies_) {
    const auto found = std::lower_bound(greatest.begin(), greatest.end(), radius_of(i));
    class_of_[i] = static_cast<int>(found - greatest.begin());
    classes_[class_of_[i]].bodies.push_back(i);
  }
}

void SizeClasses::sort(const double* x, const double* y, double reach, double cell) {
  for (Class& c : classes_) c.grid.sort(x, y, c.bodies, cell > 0 ? cell : 2 * c.greatest + reach);
}

Extent along_wall(const WallPart& wall, double within, Extent y) {
  const double lower = wall.ny * (y.from - wall.py);
  const double upper = wall.ny * (y.to - wall.py);
  if (!std::isfinite(lower + upper)) return {-infinity, infinity};
  const double slack = 1e-12 * (std::fabs(lower) + std::fabs(upper) + std::fabs(wall.px) + within);  // for rounding
  const double most = within - std::min(lower, upper) + slack;                                       // of nx (x - px)
  if (wall.nx == 0) return most > 0 ? Extent{-infinity, infinity} : Extent{infinity, -infinity};
  return wall.nx > 0 ? Extent{-infinity, wall.px + most / wall.nx} : Extent{wall.px + most / wall.nx, infinity};
}

Extent along_segment(Vec2 a, Vec2 b, double within, Extent y) {
  double from = 0, to = 1;
  if (std::fabs(b.y - a.y) > 4 * within) {  // longer than a few rows
    from = (y.from - within - a.y) / (b.y - a.y);
    to = (y.to + within - a.y) / (b.y - a.y);
    if (from > to) std::swap(from, to);
    const double slack = 1e-6 + 1e-15 * (std::fabs(a.y) + std::fabs(b.y)) / std::fabs(b.y - a.y);  // covers rounding
    from = std::clamp(from - slack, 0.0, 1.0);
    to = std::clamp(to + slack, 0.0, 1.0);
  }
  const double left = a.x + from * (b.x - a.x);
  const double right = a.x + to * (b.x - a.x);
  return {std::min(left, right) - within, std::max(left, right) + within};
}

}  // namespace furrow
