#include "studies/order_predicted.h"

#include <algorithm>
#include <cmath>

namespace furrow::studies {
namespace {

// Symplectic Euler's velocities are those of Verlet's half a step off, its positions the same where it starts and ends
// without force. With a force that depends on velocity it is plain first order.
bool leapfrog(const MethodInfo& method, const Problem& problem) {
  return method.name.ends_with("symplectic_euler") && problem.from_rest;
}

}  // namespace

std::optional<Prediction> predicted(const MethodInfo& method, const Problem& problem) {
  if (method.controlled) return std::nullopt;
  const double p = method.order;
  Prediction prediction{std::min(p, problem.limit), std::min(p, problem.limit)};
  if (leapfrog(method, problem)) prediction.position = std::min(2.0, problem.limit);
  if (problem.rebounds) {
    const bool even = method.order % 2 == 0 || leapfrog(method, problem);
    prediction.velocity = std::min(even ? prediction.position + 1 : p, problem.limit);
    prediction.at_least = true;
  }
  return prediction;
}

Exponents predicted_exponents(const MethodInfo& method, const Problem& problem) {
  // These two advance what they estimate; the others advance the better result, whose order is the estimate's power.
  const bool advances_estimated = method.name == "pece_adaptive" || method.name == "rkc";
  const double q = advances_estimated ? method.order + 1 : method.order;
  const double smooth = method.order / q;
  return {smooth, std::min(smooth, (1 + problem.limit / q) / 2)};
}

Verdict verdict(const MethodInfo& method, const Problem& problem, const std::vector<Point>& points) {
  Verdict v{fitted(points, &Point::position), fitted(points, &Point::velocity), predicted(method, problem)};
  if (!v.predicted) return v;
  v.position_holds = std::fabs(v.position.value - v.predicted->position) <= tolerance_of(v.position);
  const double excess = v.velocity.value - v.predicted->velocity;
  v.velocity_holds = (v.predicted->at_least ? -excess : std::fabs(excess)) <= tolerance_of(v.velocity);
  return v;
}

bool applies(const MethodInfo& /*method*/, const Problem& /*problem*/) { return true; }

}  // namespace furrow::studies
