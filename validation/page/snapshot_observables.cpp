#include "validation/page/snapshot_observables.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace furrow::validation {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double corner_width = 0.1, layer_height = 0.05, wall_width = 0.04, beside = 0.03;  // m
constexpr double column = 0.02;  // m, a disc's diameter: what the upper outline is taken over

struct Discs {
  std::vector<double> x, y, radius, stress;
  double left = infinity, right = -infinity;  // ends of the bed

  explicit Discs(const Frame& frame)
      : x(frame.discs.numbers("x [m]")),
        y(frame.discs.numbers("y [m]")),
        radius(frame.discs.numbers("radius [m]")),
        stress(frame.discs.numbers("von Mises [Pa]")) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      left = std::min(left, x[k] - radius[k]);
      right = std::max(right, x[k] + radius[k]);
    }
  }

  double mean_stress(const std::function<bool(double, double)>& where) const {
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (where(x[k], y[k])) sum += stress[k], count += 1;
    }
    return count > 0 ? sum / count : nan;
  }

  double top() const {
    double highest = nan;
    for (std::size_t k = 0; k < x.size(); ++k) highest = std::fmax(highest, y[k] + radius[k]);
    return highest;
  }
  double corner() const {
    return mean_stress([&](double px, double py) { return px < left + corner_width && py < layer_height; });
  }
  double layer() const {
    return mean_stress([](double, double py) { return py < layer_height; });
  }
  double at_right_end() const {
    return mean_stress([&](double px, double) { return px > right - wall_width; });
  }
};

double depth_left_behind(const Frame& frame) {
  const auto left = frame.plates.numbers("left [m]"), lower = frame.plates.numbers("lower [m]");
  if (left.empty()) return nan;
  const Discs discs(frame);
  std::map<long, double> outline;  // by column
  for (std::size_t k = 0; k < discs.x.size(); ++k) {
    if (discs.x[k] + discs.radius[k] > left[0] - column) continue;
    double& top = outline.try_emplace(std::lround(discs.x[k] / column), -infinity).first->second;
    top = std::max(top, discs.y[k] + discs.radius[k]);
  }
  double sum = 0;
  for (const auto& [where, top] : outline) sum += top - lower[0];
  return outline.empty() ? nan : 1e3 * sum / static_cast<double>(outline.size());
}

struct Ends {
  double left = nan, right = nan;
  std::vector<std::pair<double, double>> all;
};

Ends link_ends(const Frame& frame) {
  Ends ends;
  for (const std::string end : {"1", "2"}) {
    const auto x = frame.links.numbers("x" + end + " [m]"), y = frame.links.numbers("y" + end + " [m]");
    for (std::size_t k = 0; k < x.size(); ++k) {
      ends.left = std::fmin(ends.left, x[k]);
      ends.right = std::fmax(ends.right, x[k]);
      ends.all.emplace_back(x[k], y[k]);
    }
  }
  return ends;
}

double stress_at_lattice(const Frame& frame) {
  const Ends ends = link_ends(frame);
  return Discs(frame).mean_stress([&](double x, double y) {
    return std::any_of(ends.all.begin(), ends.all.end(),
                       [&](const auto& end) { return std::hypot(x - end.first, y - end.second) < beside; });
  });
}

}  // namespace

std::optional<Measured> measure_snapshots(const RunRecord& run, const std::string& observable) {
  using Compare = double (*)(const Frame& first, const Frame& second, const Frame& last);
  static const std::map<std::string, Compare> known{
      {"pile_up", [](const Frame& first, const Frame&,
                     const Frame& last) { return 1e3 * (Discs(last).top() - Discs(first).top()); }},
      {"depth_left_behind", [](const Frame&, const Frame&, const Frame& last) { return depth_left_behind(last); }},
      {"right_wall_stress", [](const Frame& first, const Frame&,
                               const Frame& last) { return Discs(last).at_right_end() / Discs(first).at_right_end(); }},
      {"corner_stress",
       [](const Frame& first, const Frame&, const Frame&) { return Discs(first).corner() / Discs(first).layer(); }},
      {"corner_relief", [](const Frame& first, const Frame&,
                           const Frame& last) { return Discs(last).corner() / Discs(first).corner(); }},
      {"stress_at_lattice", [](const Frame& first, const Frame& second,
                               const Frame&) { return stress_at_lattice(second) / stress_at_lattice(first); }},
      {"upper_part_moved", [](const Frame& first, const Frame&,
                              const Frame& last) { return 1e3 * (link_ends(last).right - link_ends(first).right); }},
      {"lower_part_moved", [](const Frame& first, const Frame&,
                              const Frame& last) { return 1e3 * (link_ends(last).left - link_ends(first).left); }},
  };
  const auto found = known.find(observable);
  if (found == known.end()) return std::nullopt;
  // A run that stopped early has not the snapshots that the paper speaks of.
  if (run.frames.size() < std::max<std::size_t>(2, run.scene.output.frames.size())) return Measured{};
  return Measured{found->second(run.frames[0], run.frames[1], run.frames.back())};
}

}  // namespace furrow::validation
