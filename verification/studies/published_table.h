// Methods by published problems: does the error fall as the method says, down to where round-off begins?
//
//   fixed steps   slope of log error over log step = p,  1 where f jumps within a step
//   controlled    slope of log error over log tolerance = s, see order_predicted.h
//
// Each with the correlation of the two: near 1, or there is no line.
#pragma once

#include "methods/method.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/published_problems.h"

namespace furrow::verification {

struct PublishedCell {
  std::string cannot{};       // why the method has no result here; empty: it has
  std::vector<Point> points;  // position: the error at the end
  Slope slope;
  double least = 0, most = 0, gate = 0;  // the slope, and how far it may be off
  double line = 0;                       // the least correlation
  bool few_steps = false;                // of a controlled method: every error is below 100 tolerances
  bool at_floor = false;                 // no order can be given above round-off: the finest three are below
  bool holds = false;
};

PublishedCell published_cell(const MethodInfo& method, const PublishedProblem& problem);

// Whether the cell is known to fail, see the page.
bool known_to_fail(const MethodInfo& method, const PublishedProblem& problem);

}  // namespace furrow::verification
