// The search of the readings: every choice that the paper leaves open, over its three scenes with one set of choices for
// all (validation/readings.toml).
//
// First each alternative alone, and points that others have named, then points drawn at random, then from the best of them pass after pass every
// alternative of every choice, the best of a choice kept; then the same from the best of those that are valid: whose
// scenes `furrow run` brings to their ends with what the literal scene files allow, and no more. The best few of all, the
// best few valid ones and the literal reading are judged again by packings that did not choose them, at the paper's step
// and at a finer one.
#pragma once

#include <functional>
#include <map>

#include "report/study.h"
#include "validation/studies/reading_runs.h"
#include "validation/studies/sentences.h"

namespace furrow::validation {

struct ReadPoint {
  Interpretation reading;
  std::map<std::string, Json> said;  // by scene
  // Of some scenes. A search compares each point with each other many times, so what was asked is remembered.
  double misfit(const std::vector<std::string>& scenes) const;
  mutable std::map<std::vector<std::string>, double> misfits{};
};

struct Finalist {
  Interpretation reading;
  std::map<std::string, std::vector<Json>> said, finer;  // by scene, packings; at the paper's step and at the finer one
  std::map<std::string, std::vector<Json>> watched;      // at the paper's step: valid, reason, reached [mm], torn
  int valid_runs() const;                                // of the watched ones
};

// How the points are chosen. The second form knows choices and points that the first did not (`since` in
// validation/readings.toml), and what it holds out it also fits without: each two scenes have exchanges of their own.
// In the first, what two scenes choose comes from points to which the misfit of all three has led.
enum class SearchForm { first = 1, second = 2 };

struct ReadingsFound {
  SearchForm form = SearchForm::second;
  std::vector<std::string> scenes;
  std::vector<ReadPoint> points;  // in the order in which they were tried: literal, alone, at random, exchanged
  std::size_t alone = 0, random = 0, exchanged = 0;                 // up to `joint` the rest: exchanged from valid ones
  std::size_t joint = 0;                                            // after these: exchanged to fit two scenes alone
  std::vector<Finalist> finalists;                                  // the literal one first, then the best
  std::map<std::string, Interpretation> valid_without;              // by scene: the best valid one of the others
  std::map<std::string, Finalist> fitted_without;                   // second form: `said` alone, by packings
  std::vector<Json> untorn;                                         // by untorn_runs()
  const ReadPoint& best(const std::vector<std::string>& of) const;  // the least misfit of those scenes
  const ReadPoint& at(const Interpretation& reading) const;
  std::vector<std::string> others(const std::string& out) const;  // the scenes but one
};

// The search. `run` makes what is wanted, or knows what it gave. The quick form looks at scene 1 alone.
using RunTasks = std::function<std::vector<Json>(const std::vector<Wanted>&)>;
ReadingsFound search_readings(const RunTasks& run, bool quick, SearchForm form = SearchForm::second);

// From what the study has kept, in the form in which it was made. Throws std::out_of_range if it is of neither.
ReadingsFound kept_search(const Numbers& numbers);

void measure_readings(Measurement& measurement);

}  // namespace furrow::validation
