// Running a scene for a check, and what checks read off a series of runs.
#pragma once

#include <cmath>
#include <vector>

#include "run/run.h"

namespace furrow::verification {

struct Ran {
  System system;
  State y;
  RunEnd end;
};

// From the scene's own start, without settling. `after_step` may be empty.
inline Ran run_scene(const Scene& scene, const std::string& method, double step, double end,
                     const AfterStep& after_step = {}) {
  Ran ran{System(scene), {}, {}};
  ran.y = ran.system.initial_state();
  const auto go_on = [](double, const State&, const JumpReport&) { return true; };
  ran.end = run(ran.system, *make_method(method), ran.y, {.start = 0, .end = end, .step = step, .stop = {}},
                after_step ? after_step : AfterStep(go_on));
  return ran;
}

// Slope of log(error) against log(step) by least squares: the observed order.
inline double fitted_slope(const std::vector<double>& steps, const std::vector<double>& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const double n = static_cast<double>(steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double x = std::log(steps[k]);
    const double y = std::log(errors[k]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace furrow::verification
