// The paper's numbers by method and step: each scene runs from the same settled bed by several methods at steps down to
// a fiftieth of the paper's. Scenes 2 and 3 are chaotic: how far a number moves when the start is changed by far less
// than any step's error shows what no step can settle.
#include "validation/studies/convergence.h"

#include <algorithm>
#include <cmath>

#include "validation/studies/beds.h"

namespace furrow::validation {
namespace {

constexpr double nudge = 1e-9;  // m/s, on the first body
constexpr int digits = 8;

Json run_of(const ConvergenceRun& one, Beds& beds) {
  Prepared prepared = beds.of(one.of.scene, one.of.reading);
  prepared.y[prepared.system.vx_of(0)] += nudge * one.nudged;
  Timing time = prepared.scene.time;
  time.method = one.method;
  time.step = one.step;
  const RunRecord run = observed_run(std::move(prepared), time);
  Json got{{"ended", run.fact("ended")->texts.at(0)}, {"reason", run.fact("reason")->texts.at(0)}};
  Json& values = got["values"] = Json::object();
  for (const Reported& r : reported(run, the_paper(), one.of.scene)) {
    if (std::isfinite(r.ours.value)) values[r.id] = to_digits(r.ours.value, digits);
  }
  double sum = 0;
  for (std::size_t k = 0; k < run.force.even(); ++k) sum += run.force.f[k];
  values["mean_force"] = to_digits(sum / static_cast<double>(run.force.even()), digits);
  return got;
}

}  // namespace

std::vector<ConvergenceRun> ConvergencePlan::runs() const {
  std::vector<ConvergenceRun> all;
  for (const ConvergenceCase& c : cases) {
    for (const double step : steps) all.push_back({c, "pece", step});
    for (const std::string& method : others) all.push_back({c, method, others_step});
    for (int n = 1; n <= nudged_runs; ++n) all.push_back({c, "pece", nudged_step, n});
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.step < b.step; });
  return all;
}

ConvergencePlan convergence_plan(bool quick) {
  if (quick) return {{{"scenario_1", Reading::disc}}, {2e-4, 1e-4, 5e-5, 2e-5}, {"rk4"}, 2e-5, 2e-5};
  return {{{"scenario_1", Reading::disc},
           {"scenario_2", Reading::disc},
           {"scenario_3", Reading::disc},
           {"scenario_2", Reading::sphere},
           {"scenario_3", Reading::sphere}},
          {2e-4, 1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6},
          {"rk4", "verlet"},
          1e-5,
          1e-5};
}

void measure_convergence(Measurement& measurement) {
  Beds beds;
  std::vector<Task> tasks;
  for (const ConvergenceRun& one : convergence_plan(measurement.quick()).runs())
    tasks.push_back({one.key(), [&beds, one] { return run_of(one, beds); },
                     hash_of_observed(paper_scene(one.of.scene, one.of.reading, 1), one.of.scene)});
  measurement.run(tasks);
}

}  // namespace furrow::validation
