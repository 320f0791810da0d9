#include "studies/observed_run.h"

#include <cmath>

#include "page/embedded.h"
#include "system/observe.h"
#include "system/run.h"

namespace furrow::studies {

RunRecord observed_run(Prepared prepared, const Timing& time) {
  System& system = prepared.system;
  const double interval = prepared.scene.output.interval;
  RunRecord record;
  record.scene = prepared.scene;
  record.lattices = system.parts();
  const PlatePart& plate = system.parts().plate.at(0);
  const double speed = 1e3 * std::hypot(plate.vx, plate.vy);  // mm/s
  const auto method = make_method(time.method, {time.relative_tolerance, time.absolute_tolerance, time.step});
  const bool controlled = method->info().controlled;
  long rows = 0;
  const auto due = [&](double t) { return t >= static_cast<double>(rows) * interval - 0.5 * time.step; };
  const RunPlan plan{
      .start = 0, .end = time.end, .step = controlled ? time.max_step : time.step, .stop = [&](double t) {
        const double next = static_cast<double>(rows) * interval;
        return next > t && next < time.end ? next : time.end;
      }};
  const RunEnd end = run(system, *method, prepared.y, plan, [&](double t, const State& y, const JumpReport& jump) {
    for (const Tear& tear : jump.torn) record.torn.push_back({speed * tear.time, tear.link});
    if (!due(t)) return true;
    const Force force = observe(system, t, y).plate.at(0);
    record.force.mm.push_back(speed * t);
    record.force.fx.push_back(0 - force.x);
    record.force.fy.push_back(force.y);
    record.force.f.push_back(std::hypot(force.x, force.y));
    while (due(t)) ++rows;
    return true;
  });
  record.facts = {{"ended", {end.ending == Ending::finished ? "finished" : "diverged"}},
                  {"reason", {end.reason}},
                  {"rhs_evaluations", {std::to_string(method->evaluations())}},
                  {"steps", {std::to_string(end.steps)}}};
  return record;
}

std::vector<Reported> reported(const RunRecord& run, const Publication& paper, const std::string& scene) {
  std::vector<Reported> all;
  for (const Statement& s : paper.statements) {
    if (s.scene == scene) all.push_back({s.id, measure(run, s.observable, s.window)});
  }
  return all;
}

const Publication& the_paper() {
  static const Publication paper = read_publication(embedded("reference_data/published/paper.toml"));
  return paper;
}

}  // namespace furrow::studies
