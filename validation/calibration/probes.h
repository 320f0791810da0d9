// The slopes about a point: each key with a range is tried a little below and a little above.
#pragma once

#include "validation/calibration/evaluate.h"
#include "validation/calibration/linear_theory.h"

namespace furrow::validation {

// Of the evaluator's keys, those that are not listed.
std::vector<std::size_t> ranged_keys(const Evaluator& evaluator);

// Of all targets, in tolerances, mean over the packings.
Eigen::VectorXd residuals_of(const Evaluator& evaluator, const Point& point);

// One key on both sides, at the ends of what its range allows.
struct Probe {
  double below = 0, above = 0;  // shares
  Point low, high;
  double width() const { return above - below; }
};

// `reach`: how far to each side, in shares of the ranges. Takes two runs a key, scene and packing.
std::vector<Probe> probes_of(const Evaluator& evaluator, const Point& best, const std::vector<std::size_t>& ranged,
                             const Eigen::VectorXd& reach, const Packings& packings);

// Where a run says nothing there is no slope.
bool all_whole(const Point& best, const std::vector<Probe>& probes);

// With the weights of the targets, as of squares.
Slopes slopes_about(const Evaluator& evaluator, const Point& best, const std::vector<std::size_t>& ranged,
                    const std::vector<Probe>& probes);

// With the weights that make the least squares go along the misfit, if its loss is bounded.
Slopes of_loss(const Evaluator& evaluator, Slopes about);

}  // namespace furrow::validation
