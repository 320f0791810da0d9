#include "validation/page/sentence_observables.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace furrow::validation {
namespace {

using Window = std::array<double, 2>;  // mm

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double beside_the_meeting = 30;                                   // mm
constexpr double corner_width = 0.1, layer_height = 0.05, same_end = 1e-9;  // m

// Samples of a window, by index.
std::vector<std::size_t> samples_in(const ForceCurve& c, const Window& w, std::size_t end) {
  std::vector<std::size_t> samples;
  for (std::size_t k = 0; k < end; ++k) {
    if (c.mm[k] >= w[0] && c.mm[k] <= w[1]) samples.push_back(k);
  }
  return samples;
}

double mean_magnitude(const ForceCurve& c, const std::vector<double>& force, const Window& w) {
  double sum = 0;
  const std::vector<std::size_t> samples = samples_in(c, w, c.even());
  for (const std::size_t k : samples) sum += std::fabs(force[k]);
  return sum / static_cast<double>(samples.size());
}

double place_of_largest(const ForceCurve& c, const std::vector<double>& force, const Window& w) {
  double largest = -1, at = nan;
  for (const std::size_t k : samples_in(c, w, c.mm.size())) {
    if (std::fabs(force[k]) > largest) largest = std::fabs(force[k]), at = c.mm[k];
  }
  return at;
}

Window first_contact(const RunRecord& run) {
  const ForceCurve& c = run.force;
  const auto first = std::find_if(c.f.begin(), c.f.end(), [](double f) { return f > 0; });
  const double ended = measure(run, "free_flight_begins").value;
  return {first == c.f.end() ? nan : c.mm[static_cast<std::size_t>(first - c.f.begin())],
          std::isnan(ended) ? c.end() : ended};
}

double change_in_first_contact(const RunRecord& run, const std::vector<double>& force) {
  const Window w = first_contact(run);
  const double middle = 0.5 * (w[0] + w[1]);
  return mean_magnitude(run.force, force, {middle, w[1]}) - mean_magnitude(run.force, force, {w[0], middle});
}

Window second_contact(const RunRecord& run) { return {measure(run, "free_flight_ends").value, run.force.end()}; }

double largest_fy_at(const RunRecord& run) { return place_of_largest(run.force, run.force.fy, second_contact(run)); }

double links_torn(const RunRecord& run, const Window& w) {
  return static_cast<double>(
      std::count_if(run.torn.begin(), run.torn.end(), [&](const TornLink& t) { return t.mm >= w[0] && t.mm <= w[1]; }));
}

double first_tear_row(const RunRecord& run) {
  if (run.torn.empty()) return nan;
  const int link = run.torn[0].link;
  return 1 +
         std::max(run.lattices.node.row[run.lattices.link.a[link]], run.lattices.node.row[run.lattices.link.b[link]]);
}

double contacts_per_100(const ForceCurve& c) {
  int contacts = 0;
  for (std::size_t k = 0; k < c.f.size(); ++k) contacts += c.f[k] > 0 && (k == 0 || c.f[k - 1] == 0) ? 1 : 0;
  return 100 * contacts / c.end();
}

double correlation(const ForceCurve& c, const Window& w) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (const std::size_t k : samples_in(c, w, c.even())) {
    const double x = std::fabs(c.fx[k]), y = std::fabs(c.fy[k]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y, syy += y * y;
  }
  return (n * sxy - sx * sy) / std::sqrt((n * sxx - sx * sx) * (n * syy - sy * sy));
}

double mean_rise(const ForceCurve& c, const Window& w) {
  const double middle = 0.5 * (w[0] + w[1]);
  return mean_magnitude(c, c.f, {middle, w[1]}) / mean_magnitude(c, c.f, {w[0], middle});
}

double fy_appears(const RunRecord& run) {
  const double met = run.met.value_or(nan);
  const ForceCurve& c = run.force;
  return mean_magnitude(c, c.fy, {met, met + beside_the_meeting}) -
         mean_magnitude(c, c.fy, {met - beside_the_meeting, met});
}

// Ends of links, m.
std::vector<std::array<double, 4>> links_of(const Frame& frame) {
  const auto x1 = frame.links.numbers("x1 [m]"), y1 = frame.links.numbers("y1 [m]");
  const auto x2 = frame.links.numbers("x2 [m]"), y2 = frame.links.numbers("y2 [m]");
  std::vector<std::array<double, 4>> links;
  for (std::size_t k = 0; k < x1.size(); ++k) links.push_back({x1[k], y1[k], x2[k], y2[k]});
  return links;
}

double right_end(const Frame& frame) {
  double right = nan;
  for (const auto& [x1, y1, x2, y2] : links_of(frame)) right = std::fmax(right, std::max(x1, x2));
  return right;
}

double corner(const Frame& frame) {
  const auto x = frame.discs.numbers("x [m]"), y = frame.discs.numbers("y [m]"),
             radius = frame.discs.numbers("radius [m]"), stress = frame.discs.numbers("von Mises [Pa]");
  double left = nan, sum = 0, count = 0;
  for (std::size_t k = 0; k < x.size(); ++k) left = std::fmin(left, x[k] - radius[k]);
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (x[k] < left + corner_width && y[k] < layer_height) sum += stress[k], count += 1;
  }
  return sum / count;
}

// The lowest end, and what hangs together with it by intact links.
double lower_part_leans(const Frame& frame) {
  using End = std::pair<double, double>;  // y, x
  std::vector<std::pair<End, End>> links;
  std::set<End> part;
  End lowest{infinity, 0};
  for (const auto& [x1, y1, x2, y2] : links_of(frame)) {
    links.push_back({{y1, x1}, {y2, x2}});
    lowest = std::min({lowest, links.back().first, links.back().second});
  }
  for (const auto& [a, b] : links) {
    for (const End& end : {a, b}) {
      if (end.first < lowest.first + same_end) part.insert(end);
    }
  }
  for (bool grown = !part.empty(); grown;) {
    grown = false;
    for (const auto& [a, b] : links) {
      if (part.contains(a) != part.contains(b)) part.insert({a, b}), grown = true;
    }
  }
  return part.empty() ? nan : 1e3 * std::fabs(part.rbegin()->second - part.begin()->second);
}

// Of snapshots: only where the run has all of its scene.
double of_frames(const RunRecord& run, double (*of)(const std::vector<Frame>&)) {
  const bool all = run.frames.size() >= std::max<std::size_t>(4, run.scene.output.frames.size());
  return all ? of(run.frames) : nan;
}

using Compute = double (*)(const RunRecord&, const Window&);

const std::map<std::string, Compute>& computed() {
  using R = const RunRecord&;
  using W = const Window&;
  static const std::map<std::string, Compute> all{
      {"links_torn", links_torn},
      {"first_tear_row", [](R run, W) { return first_tear_row(run); }},
      {"first_contact_fx_change", [](R run, W) { return change_in_first_contact(run, run.force.fx); }},
      {"first_contact_fy_change", [](R run, W) { return change_in_first_contact(run, run.force.fy); }},
      {"second_contact_order",
       [](R run, W) { return largest_fy_at(run) - place_of_largest(run.force, run.force.fx, second_contact(run)); }},
      {"split_after_fy", [](R run, W) { return measure(run, "split").value - largest_fy_at(run); }},
      {"contacts_per_100", [](R run, W) { return contacts_per_100(run.force); }},
      {"proportional", [](R run, W w) { return correlation(run.force, w); }},
      {"mean_rise", [](R run, W w) { return mean_rise(run.force, w); }},
      {"fy_appears", [](R run, W) { return fy_appears(run); }},
      {"largest_before_split",
       [](R run, W) { return measure(run, "split").value - measure(run, "largest_force_at").value; }},
      {"bent_at_second",
       [](R run, W) {
         return of_frames(run, [](const auto& f) { return 1e3 * (right_end(f[1]) - right_end(f[0])); });
       }},
      {"bent_more",
       [](R run, W) {
         return of_frames(run, [](const auto& f) { return 1e3 * (right_end(f[f.size() - 2]) - right_end(f[1])); });
       }},
      {"corner_relief_second",
       [](R run, W) { return of_frames(run, [](const auto& f) { return corner(f[1]) / corner(f[0]); }); }},
      {"corner_relief_third",
       [](R run, W) { return of_frames(run, [](const auto& f) { return corner(f[2]) / corner(f[0]); }); }},
      {"lower_part_leans",
       [](R run, W) { return of_frames(run, [](const auto& f) { return lower_part_leans(f.back()); }); }},
  };
  return all;
}

}  // namespace

std::optional<Measured> measure_sentences(const RunRecord& run, const std::string& name, const Window& window) {
  const auto found = computed().find(name);
  if (found == computed().end()) return {};
  const double value = found->second(run, window);
  const bool of_split = name == "split_after_fy" || name == "largest_before_split";
  if (of_split && std::isnan(measure(run, "split").value)) return Measured{.words = "not by the end"};
  if (name == "first_tear_row" && run.torn.empty()) return Measured{.words = "not by the end"};
  return Measured{value};
}

const std::vector<std::string>& sentence_observable_names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const auto& [name, compute] : computed()) names.push_back(name);
    return names;
  }();
  return all;
}

}  // namespace furrow::validation
