#include "validation/calibration/judge_targets.h"

#include <algorithm>
#include <cmath>

#include "scene/wording.h"

namespace furrow::validation {
namespace {

// The greatest magnitude among what the target compares with.
double size_of_value(const CalibrationTarget& target) {
  double size = std::max(std::fabs(target.value[0]), std::fabs(target.value[1]));
  if (!target.curve) return size;
  for (const double force : target.curve->force) size = std::max(size, std::fabs(force));
  return size;
}

bool want_the_same(const CalibrationTarget& a, const CalibrationTarget& b) {
  if (a.asked() != b.asked() || a.relation != b.relation || a.value != b.value || a.words != b.words) return false;
  return !a.curve || a.curve->force == b.curve->force;
}

std::string numbered(std::size_t k) { return "target " + std::to_string(k + 1); }

}  // namespace

std::string fault_of_tolerance(const CalibrationTarget& target) {
  const double size = size_of_value(target);
  if (!(size > 0) || !(target.tolerance > 0)) return {};
  const double least = least_of_value * size, most = most_of_value * size;
  if (target.tolerance >= least && target.tolerance <= most) return {};
  return "tolerance must be from " + shortest(least_of_value) + " to " + shortest(most_of_value) + " times the " +
         (target.curve ? "largest force of the curve" : "value") + ", " + rounded(size, 6) + ", not " +
         shortest(target.tolerance);
}

std::vector<std::string> faults_between(const std::vector<CalibrationTarget>& targets,
                                        const std::vector<std::string>& scenes) {
  std::vector<std::string> faults;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      if (targets[i].scene != targets[k].scene) continue;
      if (want_the_same(targets[i], targets[k]))
        faults.push_back(numbered(k) + ": wants the same as " + numbered(i) +
                         "; leave one out, or give it more weight");
      else if (targets[i].named && targets[k].named && targets[i].name == targets[k].name)
        faults.push_back(numbered(k) + ": is named " + in_quotes(targets[k].name) + ", as " + numbered(i) +
                         "; give each its own name");
    }
  }
  for (const std::string& scene : scenes) {
    if (std::none_of(targets.begin(), targets.end(), [&](const auto& t) { return t.scene == scene; }))
      faults.push_back("no [[target]] is of scene " + in_quotes(scene) + ": add one, or leave the scene out");
  }
  return faults;
}

}  // namespace furrow::validation
