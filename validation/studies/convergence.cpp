// The paper's numbers by method and step: each scene runs from the same settled bed by several methods at steps down to
// a fiftieth of the paper's. Scenes 2 and 3 are chaotic: how far a number moves when the start is changed by far less
// than any step's error shows what no step can settle.
#include "validation/studies/convergence.h"

#include <algorithm>
#include <cmath>

#include "report/seal.h"
#include "run/run.h"
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
  for (const Reported& r : reported(run, the_paper(), one.of.of_paper())) {
    if (std::isfinite(r.ours.value)) values[r.id] = to_digits(r.ours.value, digits);
  }
  double sum = 0;
  for (std::size_t k = 0; k < run.force.even(); ++k) sum += run.force.f[k];
  values["mean_force"] = to_digits(sum / static_cast<double>(run.force.even()), digits);
  return got;
}

// A run that says how much energy it makes is ended by nothing.
Allow everything() {
  constexpr double any = 1e9;
  return {.energy_made = any,
          .energy_lost = any,
          .overlap = any,
          .step = any,
          .behind_walls = true,
          .through_plates = true,
          .through_lattices = true,
          .crossing_lattices = true};
}

// The same run with its energy booked as `furrow run` books it; with a bed of its own, since a bed settles with or
// without a ledger.
Json energy_of(const ConvergenceRun& one) {
  Scene scene = paper_scene(one.of.scene, one.of.reading, 1);
  scene.time.method = one.method;
  scene.time.step = one.step;
  if (scene.settle && !scene.settle->step) scene.settle->step = papers_step;
  scene.output.energy = true;
  scene.allow = everything();
  Prepared prepared = prepare(scene);
  const Timing& time = prepared.scene.time;
  System& system = prepared.system;
  Validity validity(system, prepared.scene, [](const std::string&) {});
  const auto method = make_method(time.method);
  const RunPlan plan{.start = 0, .end = time.end, .step = time.step, .stop = {}, .validity = &validity};
  const RunEnd end =
      run(system, *method, prepared.y, plan, [](double, const State&, const JumpReport&) { return true; });
  if (end.ending == Ending::diverged) throw Divergence(end.reason);
  const auto worst = [&](WatchKind kind) {
    return to_digits(validity.watches()[static_cast<std::size_t>(kind)].worst, digits);
  };
  return {{"made", worst(WatchKind::energy_made)}, {"lost", worst(WatchKind::energy_lost)}};
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

std::vector<ConvergenceRun> ConvergencePlan::booked_runs() const {
  std::vector<ConvergenceRun> all;
  for (const ConvergenceRun& one : runs()) {
    if (one.method == "pece" && one.nudged == 0) all.push_back(one);
  }
  return all;
}

ConvergencePlan convergence_plan(bool quick) {
  if (quick) return {{{"scenario_1", Reading::disc}}, {2e-4, 1e-4, 5e-5, 2e-5}, {"rk4"}, 2e-5, 2e-5};
  return {{{"scenario_1", Reading::disc},
           {"scenario_2", Reading::disc},
           {"scenario_3", Reading::disc},
           {"scenario_2", Reading::sphere},
           {"scenario_3", Reading::sphere},
           {best_reading + "scenario_1", Reading::disc},
           {best_reading + "scenario_2", Reading::disc},
           {best_reading + "scenario_3", Reading::disc}},
          {2e-4, 1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6},
          {"rk4", "verlet"},
          1e-5,
          1e-5};
}

void measure_convergence(Measurement& measurement) {
  Beds beds;
  std::vector<Task> tasks;
  const ConvergencePlan plan = convergence_plan(measurement.quick());
  for (const ConvergenceRun& one : plan.runs())
    tasks.push_back({one.key(), [&beds, one] { return run_of(one, beds); },
                     hash_of_observed(paper_scene(one.of.scene, one.of.reading, 1), one.of.of_paper())});
  for (const ConvergenceRun& one : plan.booked_runs())
    tasks.push_back({one.energy_key(), [one] { return energy_of(one); },
                     hash_of_scene(paper_scene(one.of.scene, one.of.reading, 1))});
  measurement.run(tasks);
}

}  // namespace furrow::validation
