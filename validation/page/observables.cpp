#include "validation/page/observables.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "validation/page/sentence_observables.h"
#include "validation/page/snapshot_observables.h"

namespace furrow::validation {
namespace {

using Window = std::array<double, 2>;  // mm

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Samples [first, last) of a window; none if the run ended before the window does.
struct Samples {
  std::size_t first = 0, last = 0;
};

Samples samples_in(const ForceCurve& c, Window w) {
  constexpr double slack = 1;  // mm, by which a run may fall short of the window
  if (!(w[0] <= w[1]) || c.end() < w[1] - slack) return {};
  return {static_cast<std::size_t>(std::lower_bound(c.mm.begin(), c.mm.end(), w[0]) - c.mm.begin()),
          static_cast<std::size_t>(std::upper_bound(c.mm.begin(), c.mm.end(), w[1]) - c.mm.begin())};
}

// Of those, the ones that a mean or a share counts.
Samples even(const ForceCurve& c, Samples s) { return {s.first, std::max(s.first, std::min(s.last, c.even()))}; }

// Index of the largest value in magnitude (`sign` -1: the smallest); `last` if there is none or one is NaN.
std::size_t extreme(const std::vector<double>& values, Samples s, double sign = 1) {
  std::size_t best = s.last;
  for (std::size_t k = s.first; k < s.last; ++k) {
    if (std::isnan(values[k])) return s.last;
    if (best == s.last || sign * std::abs(values[k]) > sign * std::abs(values[best])) best = k;
  }
  return best;
}

double value_at(const std::vector<double>& values, Samples s, std::size_t k) { return k == s.last ? nan : values[k]; }

double largest(const std::vector<double>& values, Samples s) {
  return std::abs(value_at(values, s, extreme(values, s)));
}

double mean(const std::vector<double>& values, Samples s) {
  double sum = 0;
  for (std::size_t k = s.first; k < s.last; ++k) sum += values[k];
  return sum / static_cast<double>(s.last - s.first);
}

double force_ratio(const ForceCurve& c, Samples s) {
  double fx = 0, fy = 0;
  for (std::size_t k = s.first; k < s.last; ++k) fx += std::abs(c.fx[k]), fy += std::abs(c.fy[k]);
  return fy > 0 ? fx / fy : nan;
}

// Share of the run in percent.
double force_free_share(const ForceCurve& c) {
  const auto last = c.f.begin() + static_cast<std::ptrdiff_t>(c.even());
  return 100 * static_cast<double>(std::count(c.f.begin(), last, 0.0)) / static_cast<double>(c.even());
}

// Least-squares exponential through the largest forces per 50 mm.
struct Growth {
  double factor = nan;     // per 100 mm
  double explained = nan;  // share of the variance of their logarithms, R^2
};

Growth growth_of_maxima(const ForceCurve& c) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (const auto& [mm, f] : maxima(c, 50)) {
    const double x = mm / 100, y = std::log(f);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y, syy += y * y;
  }
  if (n < 3) return {};
  const double xx = n * sxx - sx * sx, xy = n * sxy - sx * sy, yy = n * syy - sy * sy;
  return {std::exp(xy / xx), xy * xy / (xx * yy)};
}

// The first contact ends where nothing touches the plate for 1 mm or more before the second begins. mm; NaN: never.
struct Contacts {
  double first = nan, ended = nan, second = nan;
};

Contacts contacts_of(const ForceCurve& c) {
  Contacts found;
  double since = nan;  // mm, start of the stretch without force that we are in
  for (std::size_t k = 0; k < c.mm.size(); ++k) {
    if (c.f[k] == 0) {
      if (std::isnan(since)) since = c.mm[k];
      continue;
    }
    if (std::isnan(found.first)) {
      found.first = c.mm[k];
    } else if (c.mm[k] - since >= 1) {
      return {found.first, since, c.mm[k]};
    }
    since = nan;
  }
  return found;
}

// How many nodes chains of intact links join to the lowest row and to the highest, or none if they are the same nodes.
struct Pieces {
  int low = 0, high = 0;
};

Pieces pieces_of(const Parts& parts, const std::vector<char>& torn) {
  std::vector<int> top(parts.lattice.size(), 0);
  for (int k = 0; k < parts.node.count(); ++k) {
    int& row = top[parts.node.lattice[k]];
    row = std::max(row, parts.node.row[k]);
  }
  std::vector<int> joined(parts.node.row.size());  // to the lowest row: 1, to the highest: 2
  for (int k = 0; k < parts.node.count(); ++k) {
    joined[k] = (parts.node.row[k] == 0 ? 1 : 0) | (parts.node.row[k] == top[parts.node.lattice[k]] ? 2 : 0);
  }
  for (bool grown = true; grown;) {
    grown = false;
    for (int k = 0; k < parts.link.count(); ++k) {
      int &a = joined[parts.link.a[k]], &b = joined[parts.link.b[k]];
      if (torn[k] || a == b) continue;
      a = b = a | b;
      grown = true;
    }
  }
  if (std::count(joined.begin(), joined.end(), 3) > 0) return {};
  return {static_cast<int>(std::count(joined.begin(), joined.end(), 1)),
          static_cast<int>(std::count(joined.begin(), joined.end(), 2))};
}

// Displacement of the plate from which no chain of links joins the lowest row of a lattice to the highest. mm; NaN:
// never.
struct Split {
  double mm = nan;
  Pieces pieces;
};

Split split_of(const RunRecord& run) {
  std::vector<char> torn(run.lattices.link.a.size());
  for (const TornLink& t : run.torn) {
    torn[t.link] = 1;
    const Pieces pieces = pieces_of(run.lattices, torn);
    if (pieces.low + pieces.high > 0) return {t.mm, pieces};
  }
  return {};
}

double fixed_links_torn(const RunRecord& run) {
  int left = 0;
  for (int k = 0; k < run.lattices.link.count(); ++k) left += half_fixed(run.lattices, k);
  for (const TornLink& t : run.torn) {
    if (half_fixed(run.lattices, t.link) && --left == 0) return t.mm;
  }
  return nan;
}

std::string place_of(const Parts& parts, int link) {
  const auto node = [&](int k) {
    return "row " + std::to_string(parts.node.row[k] + 1) + ", column " + std::to_string(parts.node.column[k] + 1) +
           (parts.node.body[k] < 0 ? " (fixed)" : "");
  };
  return node(parts.link.a[link]) + " to " + node(parts.link.b[link]);
}

// For what need not happen in a run at all, other than what a run does not say.
Measured if_ever(double mm) { return {mm, std::isnan(mm) ? "not by the end" : ""}; }

Measured lattice_observable(const RunRecord& run, const std::string& name) {
  const ForceCurve& c = run.force;
  const auto structural = [&](const TornLink& t) { return run.lattices.link.kind[t.link] == LinkClass::structural; };
  const auto first = std::find_if(run.torn.begin(), run.torn.end(), structural);
  const bool any = first != run.torn.end();
  if (name == "first_tear") return if_ever(run.torn.empty() ? nan : run.torn[0].mm);
  if (name == "first_structural_tear") return if_ever(any ? first->mm : nan);
  if (name == "first_structural_tear_place") return {.words = any ? place_of(run.lattices, first->link) : "none torn"};
  if (name == "fixed_links_torn") return if_ever(fixed_links_torn(run));
  if (name == "plate_meets_lattice") return run.met ? if_ever(*run.met) : Measured{};

  const Split split = split_of(run);
  if (name == "split") return if_ever(split.mm);
  const Samples after = samples_in(c, {split.mm, c.end()});
  const std::string none = std::isnan(split.mm) ? "no split" : "";
  if (name == "smallest_force_after_split") return {value_at(c.f, after, extreme(c.f, after, -1)), none};
  if (name == "largest_force_after_split") return {largest(c.f, after), none};
  if (name != "pieces") throw std::invalid_argument("there is no observable '" + name + "'");
  if (!none.empty()) return {.words = none};
  return {static_cast<double>(split.pieces.low) / run.lattices.node.count()};
}

}  // namespace

Measured measure(const RunRecord& run, const std::string& name, std::optional<Window> window) {
  const ForceCurve& c = run.force;
  if (c.mm.empty()) return {};
  const Samples s = samples_in(c, window.value_or(Window{0, c.end()}));
  if (name == "largest_force") return {largest(c.f, s)};
  if (name == "largest_fx") return {largest(c.fx, s)};
  if (name == "largest_fy") return {largest(c.fy, s)};
  if (name == "mean_force") return {mean(c.f, even(c, s))};
  if (name == "mean_fx") return {mean(c.fx, even(c, s))};
  if (name == "mean_fy") return {mean(c.fy, even(c, s))};
  if (name == "largest_force_at") return {value_at(c.mm, s, extreme(c.f, s))};
  if (name == "force_ratio") return {force_ratio(c, even(c, s))};
  if (name == "force_free_share") return {force_free_share(c)};
  if (name == "growth_of_maxima") return {growth_of_maxima(c).factor};
  if (name == "exponential_share") return {growth_of_maxima(c).explained};
  if (name == "finished")
    return {run.finished() ? 1.0 : 0.0, run.finished() ? "comes to its end" : "does not come to its end"};
  if (const auto seen = measure_snapshots(run, name)) return *seen;
  if (const auto said = measure_sentences(run, name, window.value_or(Window{0, c.end()}))) return *said;
  const Contacts contacts = contacts_of(c);
  const double first_end = std::isnan(contacts.ended) ? c.end() : contacts.ended;
  if (name == "first_impact") return {largest(c.fx, samples_in(c, {contacts.first, first_end}))};
  if (name == "free_flight_begins") return if_ever(contacts.ended);
  if (name == "free_flight_ends") return if_ever(contacts.second);
  const Samples second = samples_in(c, {contacts.second, c.end()});
  const std::string none = std::isnan(contacts.second) ? "no second contact" : "";
  if (name == "second_contact_fx") return {largest(c.fx, second), none};
  if (name == "second_contact_fy") return {largest(c.fy, second), none};
  return lattice_observable(run, name);
}

const std::vector<std::string>& observable_names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names{"largest_force",
                                   "largest_fx",
                                   "largest_fy",
                                   "mean_force",
                                   "mean_fx",
                                   "mean_fy",
                                   "largest_force_at",
                                   "force_ratio",
                                   "force_free_share",
                                   "growth_of_maxima",
                                   "exponential_share",
                                   "finished",
                                   "first_impact",
                                   "free_flight_begins",
                                   "free_flight_ends",
                                   "second_contact_fx",
                                   "second_contact_fy",
                                   "first_tear",
                                   "first_structural_tear",
                                   "first_structural_tear_place",
                                   "fixed_links_torn",
                                   "plate_meets_lattice",
                                   "split",
                                   "pieces",
                                   "smallest_force_after_split",
                                   "largest_force_after_split",
                                   "pile_up",
                                   "depth_left_behind",
                                   "right_wall_stress",
                                   "corner_stress",
                                   "corner_relief",
                                   "stress_at_lattice",
                                   "upper_part_moved",
                                   "lower_part_moved"};
    names.insert(names.end(), sentence_observable_names().begin(), sentence_observable_names().end());
    return names;
  }();
  return all;
}

std::vector<std::array<double, 2>> maxima(const ForceCurve& curve, double length) {
  std::vector<std::array<double, 2>> found;
  for (double from = 0; from + length <= curve.end() + 1; from += length) {
    const Samples s = samples_in(curve, {from, from + length});
    const std::size_t k = extreme(curve.f, s);
    found.push_back({value_at(curve.mm, s, k), value_at(curve.f, s, k)});
  }
  return found;
}

bool half_fixed(const Parts& lattices, int link) {
  return (lattices.node.body[lattices.link.a[link]] < 0) != (lattices.node.body[lattices.link.b[link]] < 0);
}

}  // namespace furrow::validation
