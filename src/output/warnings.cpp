#include "output/warnings.h"

#include <algorithm>

#include "methods/method.h"
#include "scene/read.h"

namespace furrow {

std::vector<std::string> warnings_before(const Scene& scene) {
  std::vector<std::string> warnings = scene_warnings(scene);
  if (make_method(scene.time.method)->info().controlled) return warnings;
  const Timing& time = scene.time;
  const Timing defaults;
  const auto idle = [&](double given, double otherwise, const char* key) {
    if (given != otherwise)
      warnings.push_back(std::string("time.") + key + ": has no effect: " + time.method + " takes fixed steps");
  };
  idle(time.relative_tolerance, defaults.relative_tolerance, "relative_tolerance");
  idle(time.absolute_tolerance, defaults.absolute_tolerance, "absolute_tolerance");
  idle(time.max_step, defaults.max_step, "max_step");
  return warnings;
}

std::vector<std::string> warnings_of_lowered_plates(const Scene& asked, const Scene& placed) {
  std::vector<std::string> warnings;
  if (std::none_of(asked.plate.begin(), asked.plate.end(), [](const Plate& p) { return p.working_depth.has_value(); }))
    return warnings;
  const std::vector<std::string> before = scene_warnings(asked);
  for (const std::string& warning : scene_warnings(placed)) {
    const bool known = std::find(before.begin(), before.end(), warning) != before.end();
    if (warning.starts_with("plate[") && !known) warnings.push_back(warning);
  }
  return warnings;
}

}  // namespace furrow
