// What the best method of all needs for an error, scene by scene, and what the paper's setting needs.
#include <algorithm>
#include <cmath>

#include "validation/page/chapters/names.h"
#include "validation/page/chapters/work_precision_found.h"

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

}  // namespace

void add_summary(Report& report, const std::vector<Found>& all) {
  Json fronts = Json::array(), stars = Json::array(), names = Json::array();
  std::string said;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::vector<Reached> front = front_of(all[k]);
    for (const Reached& r : front) fronts.push_back({k, r.cpu, r.error, r.method});
    if (const WorkPrecisionPoint* paper = paper_point(all[k])) {
      const double error = std::max(paper->error_by(all[k].info.by_force), floor_of(all[k]));
      stars.push_back({k, paper->cpu, error});
    }
    if (!front.empty()) names.push_back({k, front.back().cpu, front.back().error, scene_words(all[k].info.name)});
    said += (said.empty() ? "" : ", ") + scene_words(all[k].info.name);
  }
  report.heading("All problems in one figure");
  report.figure(
      {.name = "work_precision_summary",
       .script = "pareto.gp",
       .caption = "The least error that any method reaches in a CPU time, one line a problem, each point another "
                  "setting; stars: the "
                  "paper's method with its step. A star far above its line is what a better method would save.",
       .description = "Least error against CPU time for " + said + ", with the paper's setting above each line",
       .variables = {{"count", all.size()}},
       .blocks = {{"fronts", fronts}, {"stars", stars}, {"names", names}}});
}

}  // namespace furrow::validation
