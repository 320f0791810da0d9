#include "validation/page/chapters/work_precision_found.h"

#include <algorithm>
#include <cmath>

#include "validation/page/names.h"

namespace furrow::validation {

using namespace benchmarks;

Found found_in(const Numbers& numbers, const CaseInfo& info) {
  Found found{info, numbers.at(reference_key(info)), numbers.at(nudged_key(info)), numbers.at(spectrum_key(info)), {}};
  for (const Variant& variant : variants_on(info))
    found.method_curves.push_back(curve_from(variant, numbers.at(curve_key(info, variant))));
  return found;
}

Cheapest cheapest_at(const Found& found, double error, double WorkPrecisionPoint::*cost) {
  Cheapest best;
  for (const WorkPrecisionCurve& method_curve : found.method_curves) {
    const double its = cost_at(method_curve, error, found.info.by_force, cost);
    if (its < best.cost || (std::isnan(best.cost) && !std::isnan(its))) best = {method_curve.name(), its};
  }
  return best;
}

const WorkPrecisionCurve& paper_curve(const Found& found) {
  return *std::find_if(found.method_curves.begin(), found.method_curves.end(),
                       [](const WorkPrecisionCurve& l) { return l.name() == "pece"; });
}

const WorkPrecisionPoint* paper_point(const Found& found) {
  for (const WorkPrecisionPoint& p : paper_curve(found).points) {
    if (std::fabs(p.setting / paper_step - 1) < 1e-6 && p.failure.empty()) return &p;
  }
  return nullptr;
}

double floor_of(const Found& found) {
  const char* by = found.info.by_force ? "force" : "place";
  return found.reference.contains(by) ? 10 * found.reference[by].get<double>() : NAN;
}

void add_references(Report& report, const std::vector<Found>& all) {
  std::vector<std::vector<Json>> rows;
  for (const Found& f : all) {
    if (f.reference.contains("failed")) {
      rows.push_back({scene_words(f.info.name), "failed: " + f.reference["failed"].get<std::string>()});
      continue;
    }
    rows.push_back({scene_words(f.info.name), without_scene(f.info.title),
                    f.info.by_force ? "force curve" : "positions", 1e3 * f.info.reference_step, f.reference["other"],
                    f.reference["place"], f.reference["force"], floor_of(f), f.reference["torn"]});
  }
  report.table(
      "References: rk4 at a short step, and a method that shares nothing with it. The charts end where the two "
      "differ by a tenth of the error. Scene 3's begins where the paper has the plate meet the lattice; here it meets "
      "it later, as "
      "the scene says.",
      {"scene", "what happens", "judged by", "step of rk4 [ms]", "the other", "difference, positions",
       "difference, force curve", "smallest error shown", "links torn"},
      rows);
}

std::string spelt_out(const std::string& method) {
  for (const auto& [mark, meaning] : {std::pair<std::string, std::string>{" +t", ", steps ended at tears"},
                                      {" +e", ", steps ended at touches, slips and tears"}}) {
    if (method.ends_with(mark)) return method.substr(0, method.size() - mark.size()) + meaning;
  }
  return method;
}

void add_predictability(Report& report, const std::vector<Found>& all) {
  std::vector<std::vector<Json>> rows;
  const auto until = [](const Json& time) { return time.is_null() ? Json("never") : time; };
  for (const Found& f : all) {
    if (f.foretold.contains("failed")) {
      rows.push_back({scene_words(f.info.name), "failed: " + f.foretold["failed"].get<std::string>()});
      continue;
    }
    const Json& t = f.foretold["until"];
    rows.push_back(
        {scene_words(f.info.name), f.foretold["watched"], f.foretold["grown"], until(t[0]), until(t[1]), until(t[2])});
  }
  report.table(
      "How long the scenes can be foretold: two runs whose starts differ by 1e-12 of each position (pece at "
      "0.025 ms), by how much that has grown at the end of the chart, and when they differ by more than a "
      "fraction of the way that the bodies have gone.",
      {"scene", "watched [s]", "grown, times", "1e-9 apart [s]", "1e-6 apart [s]", "1e-3 apart [s]"}, rows);
}

}  // namespace furrow::validation
