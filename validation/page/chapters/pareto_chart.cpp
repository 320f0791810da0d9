// What the best method of all needs for an error, scene by scene, and what the paper's setting needs.
#include <algorithm>
#include <cmath>

#include "validation/page/chapters/work_precision_found.h"
#include "validation/page/names.h"

namespace furrow::validation {
namespace {

using namespace benchmarks;

struct Reached {
  double cpu, error;
  std::string method;
};

// The cheapest first; what is dearer and no more accurate is left out.
std::vector<Reached> front_of(const Found& f) {
  std::vector<Reached> all;
  for (const WorkPrecisionCurve& curve : f.method_curves) {
    for (const WorkPrecisionPoint& p : curve.points) {
      const double error = p.error_by(f.info.by_force);
      if (p.failure.empty() && error <= 1) all.push_back({p.cpu, std::max(error, floor_of(f)), curve.name()});
    }
  }
  std::sort(all.begin(), all.end(), [](const Reached& a, const Reached& b) { return a.cpu < b.cpu; });
  double best = infinity;
  std::erase_if(all, [&best](const Reached& r) {
    if (!(r.error < best)) return true;
    best = r.error;
    return false;
  });
  return all;
}

// Panels of pareto.gp, in its pixels.
constexpr double wide = 350, high = 175, letter = 6.6, line = 14;

// What a panel shows, in logarithms of ten: from the cheapest and least error on, with room for names above and behind.
struct Panel {
  double left, right, low, top;
  double x(double cost) const { return wide * (std::log10(cost) - left) / (right - left); }
  double y(double error) const { return high * (std::log10(error) - low) / (top - low); }
  double cost(double x_px) const { return std::pow(10, left + x_px * (right - left) / wide); }
  double error(double y_px) const { return std::pow(10, low + y_px * (top - low) / high); }
};

Panel panel_of(const std::vector<Reached>& front, const WorkPrecisionPoint* paper, double papers_error) {
  Panel p{infinity, -infinity, infinity, -infinity};
  const auto take = [&](double cost, double error) {
    p.left = std::min(p.left, std::log10(cost)), p.right = std::max(p.right, std::log10(cost));
    p.low = std::min(p.low, std::log10(error)), p.top = std::max(p.top, std::log10(error));
  };
  for (const Reached& r : front) take(r.cpu, r.error);
  if (paper) take(paper->cpu, papers_error);
  return {p.left - 0.1, p.right + 0.75 * (p.right - p.left) + 0.1, p.low - 0.2, p.top + 0.35 * (p.top - p.low) + 0.3};
}

// In pixels of a panel.
struct Box {
  double left, right, low, top;
  bool meets(const Box& o) const { return left < o.right && o.left < right && low < o.top && o.low < top; }
};

Box around(double x, double y) { return {x - 8, x + 8, y - 8, y + 8}; }

// A place for a name above a point and to its right, the nearest that is within the panel and free.
Box place_of(const std::string& name, double x, double y, const std::vector<Box>& taken) {
  const double length = letter * static_cast<double>(name.size());
  Box box{};
  for (double right = 7; x + right + length < wide; right += 10) {
    for (double up = 3; y + up + line < high; up += 2) {
      box = {x + right, x + right + length, y + up, y + up + line};
      if (std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return box.meets(other); })) return box;
    }
  }
  return {x + 7, x + 7 + length, y + 3, y + 3 + line};  // nowhere is free
}

// Each method by name once, at its first point of the front: point and place of the name, which meets no other.
Json names_on(const std::vector<Reached>& front, const Panel& panel, std::size_t k, std::vector<Box> taken) {
  std::vector<std::string> named;
  Json rows = Json::array();
  for (const Reached& r : front) {
    if (std::find(named.begin(), named.end(), r.method) != named.end()) continue;
    named.push_back(r.method);
    taken.push_back(place_of(r.method, panel.x(r.cpu), panel.y(r.error), taken));
    rows.push_back(
        {k, r.cpu, r.error, panel.cost(taken.back().left), panel.error(taken.back().low + line / 2), r.method});
  }
  return rows;
}

}  // namespace

void add_summary(Report& report, const std::vector<Found>& all) {
  Json fronts = Json::array(), stars = Json::array(), names = Json::array(), panels = Json::array();
  std::string said;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::vector<Reached> front = front_of(all[k]);
    const WorkPrecisionPoint* paper = paper_point(all[k]);
    const double error = paper ? std::max(paper->error_by(all[k].info.by_force), floor_of(all[k])) : NAN;
    const Panel panel = panel_of(front, paper, error);
    const std::string title = scene_words(all[k].info.name);
    panels.push_back({k, std::pow(10, panel.left), std::pow(10, panel.right), std::pow(10, panel.low),
                      std::pow(10, panel.top), title});
    for (const Reached& r : front) fronts.push_back({k, r.cpu, r.error, r.method});
    std::vector<Box> star;
    if (paper) star = {around(panel.x(paper->cpu), panel.y(error))};
    for (const Json& row : names_on(front, panel, k, star)) names.push_back(row);
    if (paper) stars.push_back({k, paper->cpu, error});
    said += (said.empty() ? "" : ", ") + title;
  }
  report.heading("All problems in one figure");
  report.figure(
      {.name = "work_precision_summary",
       .script = "pareto.gp",
       .caption = "The Pareto front of each problem: the least error that any method reaches in a CPU time, each point "
                  "another setting; each method is named where it first stands on the front. Star: the paper's method "
                  "with its step. How far it stands to the right of the front is what a better method would save.",
       .description = "Least error against CPU time for " + said +
                      ", with the paper's setting to the right of each "
                      "front",
       .variables = {{"count", all.size()}},
       .blocks = {{"fronts", fronts}, {"stars", stars}, {"names", names}, {"panels", panels}}});
}

}  // namespace furrow::validation
