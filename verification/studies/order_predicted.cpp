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
  prediction.most = p - problem.limit <= problem.indistinct ? p : prediction.position;
  if (leapfrog(method, problem)) prediction.position = prediction.most = std::min(2.0, problem.limit);
  prediction.at_least = problem.speed_by_energy;
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
  // How far below what is predicted, or above. A slope that is not a number is infinitely far off.
  const auto off = [](const Slope& slope, double least, double most) {
    return std::isfinite(slope.value) ? std::max({0.0, least - slope.value, slope.value - most}) : no_limit;
  };
  const Prediction& want = *v.predicted;
  const double room = want.most - want.position;
  v.position_holds = off(v.position, want.position, want.most) <= tolerance_of(v.position);
  v.velocity_holds =
      off(v.velocity, want.velocity, want.at_least ? no_limit : want.velocity + room) <= tolerance_of(v.velocity);
  return v;
}

bool applies(const MethodInfo& method, const Problem& problem) { return refusal(method, *problem.system()).empty(); }

}  // namespace furrow::studies
