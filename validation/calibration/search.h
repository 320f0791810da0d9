// The search of a calibration: every combination of listed values, over ranges first globally, then locally.
//
// By NLopt, which Debian carries and which many rely on. Globally DIRECT-L (Gablonsky and Kelley 2001, J. Global Optim.
// 21, 27): it divides the ranges without chance and without derivatives, so that the same call takes the same points and
// a search that was interrupted replays its runs; it needs no start. Locally Sbplx (Rowan's Subplex): it compares misfits
// and takes no slopes, since a tear or a packing makes them jump.
#pragma once

#include "validation/calibration/evaluate.h"

namespace furrow::validation {

struct SearchPlan {
  int global_points = 60;  // for each combination of listed values
  int local_points = 40;   // for each of the best combinations
  int best = 3;            // combinations that are refined
  int packings = 1;
  unsigned jobs = 1;  // combinations at a time
};

long runs_of(const SearchPlan& plan, const Evaluator& evaluator);  // at most

// All points that were tried, the best first. Throws Interrupted; Divergence if every point failed and
// diverged or became invalid; NothingCompared if every point failed, no point says a target, or all say the same.
std::vector<Point> search(const Evaluator& evaluator, const SearchPlan& plan);

}  // namespace furrow::validation
