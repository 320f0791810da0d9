#include "output/warnings.h"

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

}  // namespace furrow
