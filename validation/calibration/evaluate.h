// A point of a calibration: all scenes with one setting, for some packings, judged by the targets.
#pragma once

#include <stdexcept>

#include "validation/calibration/runs.h"
#include "validation/calibration/targets.h"
#include "validation/calibration/varied_key.h"

namespace furrow::validation {

// Packings number first, first + 1, ...: each drawn by the scene's own seed and so many more.
struct Packings {
  int first = 0, count = 1;
};

// One of the scenes has a packing, so that a point has several runs to be made.
bool packed(const std::vector<Case>& cases);

struct Point {
  Setting setting;
  std::vector<Json> values;     // by packing: an array, a value a target
  std::vector<double> misfits;  // by packing
  std::string failure;          // why a run of it failed, if one did
  bool diverged = false;        // each run of it that failed diverged or left the validity of its laws
  int unsaid = 0;               // targets, by packing, of which no run says a value that can be compared
  double misfit() const;        // mean over the packings
  double spread() const;        // their standard deviation; NaN for one packing
};

// First by what ran, then by how many targets have a value, then by misfit: no setting is better for what it leaves
// unsaid.
bool better(const Point& a, const Point& b);
// Every run of it ended, and every target has a value.
bool whole(const Point& point);

// The runs say nothing that could be compared.
class NothingCompared : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws NothingCompared if of some target no point has a value.
void refuse_unsaid(const Targets& targets, const std::vector<Point>& points);

// Throws std::logic_error unless the point has the values and misfits of so many packings, of each target one.
void require_values(const Point& point, const Targets& targets, int packings);

// What is calibrated, and how points of it are made.
class Evaluator {
 public:
  // Throws std::invalid_argument if a target asks for what its scene does not do: a displacement that no setting reaches.
  Evaluator(std::vector<Case> cases, std::vector<VariedKey> keys, Targets targets, Runs& runs);

  // Thread-safe. Throws std::logic_error if scenes without a packing are asked for another number of them than one.
  Point at(const Setting& setting, const Packings& packings) const;
  // Several at once.
  std::vector<Point> at(const std::vector<Setting>& settings, const Packings& packings) const;

  int runs_a_point(int packings) const;  // scenes without packings run once
  bool packed() const;
  const std::vector<Case>& cases() const { return cases_; }
  const std::vector<VariedKey>& keys() const { return keys_; }
  const Targets& targets() const { return targets_; }

 private:
  Task task(const Case& of, const Setting& setting, int packing) const;
  void take(const std::vector<Json>& runs, Point& point) const;

  std::vector<Case> cases_;
  std::vector<VariedKey> keys_;
  Targets targets_;
  Runs& runs_;
};

}  // namespace furrow::validation
