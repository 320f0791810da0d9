#include "run/cut_lattices.h"

#include <algorithm>

namespace furrow {
namespace {

// Of a coordinate from `from` to `to`, where the other one goes from `at_from` to `at_to`: whether it passes both `low` and
// `high` while the other is between the bounds.
bool goes_through(double from, double to, double low, double high, double at_from, double at_to, double other_low,
                  double other_high) {
  if (!(std::min(from, to) < low && std::max(from, to) > high)) return false;
  const auto is_between = [&](double place) {
    const double other = at_from + (place - from) / (to - from) * (at_to - at_from);
    return other > other_low && other < other_high;
  };
  return is_between(low) && is_between(high);
}

}  // namespace

CrossingBorders cut_by_plates(const System& system, double t, const State& y) {
  const Parts& parts = system.parts();
  const BorderArrays& border = parts.border;
  CrossingBorders found;
  for (int k = 0; k < static_cast<int>(parts.plate.size()); ++k) {
    const PlateAt now = system.plate_at(k, t);
    const double right = now.left + parts.plate[k].width, upper = now.lower + parts.plate[k].height;
    for (const int s : system.border()) {
      const int link = border.link[s];
      if (border.a[s] == border.b[s]) continue;
      if (link >= 0 && (system.torn(link) || parts.link.kind[link] == LinkClass::shear)) continue;
      const Vec2 a = node_place(system, t, y, border.a[s]), b = node_place(system, t, y, border.b[s]);
      const bool cut = goes_through(a.x, b.x, now.left, right, a.y, b.y, now.lower, upper) ||
                       goes_through(a.y, b.y, now.lower, upper, a.x, b.x, now.left, right);
      if (cut && ++found.pairs == 1) {
        const std::string& name = parts.plate[k].name;
        found.where = "plate " + (name.empty() ? std::to_string(k) : name) + " and lattice " +
                      lattice_name(system, border.lattice[s]);
      }
    }
  }
  return found;
}

CrossingBorders standing_crossings(const System& system, double t, const State& y) {
  CrossingBorders all;
  for (const CrossingBorders& some :
       {crossing_borders(system, t, y), cut_by_plates(system, t, y), cells_inside_out(system, t, y)}) {
    if (all.pairs == 0) all.where = some.where;
    all.pairs += some.pairs;
  }
  return all;
}

// A plate that is longer than segments are is met by them across its narrow side, for as long as it is.
double least_crossing_way(const Parts& parts) {
  double least = infinity, longest = 0;
  for (const double spacing : parts.node.spacing)
    least = std::min(least, spacing), longest = std::max(longest, spacing);
  for (const PlatePart& p : parts.plate) {
    const auto [narrow, wide] = std::minmax(p.width, p.height);
    least = std::min(least, wide < 2 * longest ? narrow : wide);
  }
  return least;
}

}  // namespace furrow
