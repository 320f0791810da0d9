// Which runs the convergence study makes, and under which keys it keeps their numbers.
#pragma once

#include <string>
#include <vector>

#include "report/measurement.h"
#include "validation/studies/beds.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {

constexpr double papers_step = 1e-4;  // s

struct ConvergenceCase {
  std::string scene;
  Reading reading;
  std::string name() const { return scene + (scene == "scenario_1" ? "" : ", " + to_string(reading)); }
  std::string title() const {  // "Scene 2, discs"
    return "Scene " + scene.substr(9) + (scene == "scenario_1" ? "" : ", " + to_string(reading) + "s");
  }
};

struct ConvergenceRun {
  ConvergenceCase of;
  std::string method;
  double step;     // s
  int nudged = 0;  // which of the nudged runs; 0: none
  std::string key() const {
    return of.name() + " " + method + " " + std::to_string(1e9 * step) + " " + std::to_string(nudged);
  }
};

struct ConvergencePlan {
  std::vector<ConvergenceCase> cases;
  std::vector<double> steps;        // s, of pece; the last is the finest
  std::vector<std::string> others;  // methods that must agree at `others_step`
  double others_step, nudged_step;  // s
  int nudged_runs = 3;
  std::vector<ConvergenceRun> runs() const;
};
ConvergencePlan convergence_plan(bool quick);

void measure_convergence(Measurement& measurement);

}  // namespace furrow::validation
