// A run with its watch, as `furrow run` makes it, but for the files.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "run/validity.h"
#include "scenes.h"

namespace furrow::test {

struct WatchedRun {
  RunEnd end;
  std::array<Watched, watch_kinds> watch;
  RunExtremes extremes;
  std::vector<std::string> warnings;
  State y;
  std::size_t tears = 0;
  const Watched& of(WatchKind kind) const { return watch[static_cast<std::size_t>(kind)]; }
};

inline WatchedRun watched(Scene scene, const std::string& method, double step, double end) {
  scene.time.method = method;
  scene.time.step = step;
  scene.time.max_step = step;
  scene.time.end = end;
  System system(scene);
  WatchedRun r;
  r.y = system.initial_state();
  Validity validity(system, scene, [&](const std::string& text) { r.warnings.push_back(text); });
  RunPlan plan;
  plan.end = end;
  plan.step = step;
  plan.validity = &validity;
  const auto made = make_method(method, {scene.time.relative_tolerance, scene.time.absolute_tolerance, step});
  r.end = run(system, *made, r.y, plan, [&](double, const State&, const JumpReport& jump) {
    r.tears += jump.torn.size();
    return true;
  });
  validity.conclude();
  r.watch = validity.watches();
  r.extremes = validity.extremes();
  return r;
}

inline Scene allowing_all(Scene scene) {
  scene.allow = Allow{1e9, 1e9, 1e9, 1e9, true, true, true, true};
  return scene;
}

}  // namespace furrow::test
