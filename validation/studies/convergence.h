// Which runs the convergence study makes, and under which keys it keeps their numbers.
#pragma once

#include <string>
#include <vector>

#include "report/measurement.h"
#include "validation/studies/beds.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {

constexpr double papers_step = 1e-4;  // s

// The scene file's directory, for the best valid reading of the search.
inline const std::string best_reading = "best_reading/";

struct ConvergenceCase {
  std::string scene;  // file in validation/scenes: "scenario_2", "best_reading/scenario_2"
  Reading reading;
  bool best() const { return scene.starts_with(best_reading); }
  std::string of_paper() const { return best() ? scene.substr(best_reading.size()) : scene; }  // "scenario_2"
  std::string name() const { return scene + (of_paper() == "scenario_1" ? "" : ", " + to_string(reading)); }
  std::string title() const {  // "Scene 2, discs"
    const std::string what = best()                       ? ", best reading"
                             : of_paper() == "scenario_1" ? ""
                                                          : ", " + to_string(reading) + "s";
    return "Scene " + of_paper().substr(9) + what;
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
  // Of the run that books the energy: "made" and "lost", shares of what the scene was given.
  std::string energy_key() const { return key() + " energy"; }
};

struct ConvergencePlan {
  std::vector<ConvergenceCase> cases;
  std::vector<double> steps;        // s, of pece; the last is the finest
  std::vector<std::string> others;  // methods that must agree at `others_step`
  double others_step, nudged_step;  // s
  int nudged_runs = 3;
  std::vector<ConvergenceRun> runs() const;
  std::vector<ConvergenceRun> booked_runs() const;  // those by pece, with their energy booked
};
ConvergencePlan convergence_plan(bool quick);

void measure_convergence(Measurement& measurement);

}  // namespace furrow::validation
