// Which methods failed in the work-precision study, at which setting, and which were not run.
#include <algorithm>
#include <map>

#include "scene/wording.h"
#include "validation/page/chapters/work_precision_found.h"
#include "validation/page/names.h"

namespace furrow::validation {
namespace {

using namespace benchmarks;

// The finest setting at which a method failed; null if it never did.
const WorkPrecisionPoint* finest_failure(const WorkPrecisionCurve& curve) {
  const auto finest = std::find_if(curve.points.rbegin(), curve.points.rend(),
                                   [](const WorkPrecisionPoint& p) { return !p.failure.empty(); });
  return finest == curve.points.rend() ? nullptr : &*finest;
}

// "cannot carry forces that depend on velocity": without the method's name, what is so in the scene, and what to do.
std::string bare_reason(const WorkPrecisionCurve& curve) {
  std::string reason = curve.left_out.substr(0, curve.left_out.find_first_of(";."));
  const std::string before = "the method " + curve.method + " ";
  return reason.rfind(before, 0) == 0 ? reason.substr(before.size()) : reason;
}

}  // namespace

// All methods and all scenes in two tables.
void add_failures(Report& report, const std::vector<Found>& all) {
  std::map<std::string, std::map<std::string, std::string>> failed;     // method, scene: setting
  std::map<std::pair<std::string, std::string>, std::string> left_out;  // method and reason: scenes
  std::vector<std::string> head{"method"};
  std::string example;
  for (const Found& f : all) {
    head.push_back(scene_words(f.info.name));
    for (const WorkPrecisionCurve& curve : f.method_curves) {
      if (!curve.left_out.empty()) {
        std::string& scenes = left_out[{curve.name(), bare_reason(curve)}];
        scenes += (scenes.empty() ? "" : ", ") + scene_words(f.info.name);
      }
      const WorkPrecisionPoint* finest = finest_failure(curve);
      if (!finest) continue;
      failed[curve.name()][f.info.name] = rounded(finest->setting, 2);
      if (example.empty()) example = curve.name() + " at " + rounded(finest->setting, 2) + ": " + finest->failure;
    }
  }
  std::vector<std::vector<Json>> failures, absent;
  for (const auto& [method, by_scene] : failed) {
    std::vector<Json> row{method};
    for (const Found& f : all) row.emplace_back(by_scene.contains(f.info.name) ? by_scene.at(f.info.name) : "–");
    failures.push_back(row);
  }
  for (const auto& [what, scenes] : left_out) absent.push_back({what.first, what.second, scenes});
  report.heading("What failed, and what was not run");
  report.table(
      "The finest step that failed [s], of methods that choose their step the finest tolerance [-]. –: none failed.",
      head, failures);
  if (!example.empty()) report.text("One failure in full: " + example + ".");
  report.table("Not run, and why.", {"method", "why", "where"}, absent);
}

}  // namespace furrow::validation
