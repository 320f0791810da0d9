#include "verification/studies/order_predicted.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace furrow::verification {

double predictors_share(const MethodInfo& method) {
  constexpr std::array<double, 6> gamma{1, 1 / 2., 5 / 12., 3 / 8., 251 / 720., 95 / 288.};
  constexpr std::array<double, 6> gamma_star{1, 1 / 2., 1 / 12., 1 / 24., 19 / 720., 3 / 160.};
  const auto p = static_cast<std::size_t>(method.order);
  return method.name.starts_with("odeint_abm") ? gamma[p - 1] * gamma[p] / gamma_star[p] : 0;
}

namespace {

// Symplectic Euler's velocities are those of Verlet's half a step off, its positions the same where it starts and ends
// without force. With a force that depends on velocity it is plain first order.
bool leapfrog(const MethodInfo& method, const Problem& problem) {
  return method.name.ends_with("symplectic_euler") && problem.from_rest;
}

double gate_of(const Slope& slope, double least, const MethodInfo& method, const Problem& problem) {
  const double one_less = std::min(std::max<double>(method.order, least) - 1, problem.limit);
  const double fall = one_less < least ? least - one_less : 1;
  const double next = predictors_share(method) * problem.fastest * slope.step;
  return std::min(tolerance_of(slope) + next, fall / 2);
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
  return {smooth, std::min(smooth, (1 + problem.limit / q) / 2), 1 / q};
}

double scatter_on(const Problem& problem) { return problem.limit == no_limit ? 0.03 : 0.5; }

Verdict verdict(const MethodInfo& method, const Problem& problem, const std::vector<Point>& points) {
  const auto slope_of = [&](double Point::*error) {
    return problem.limit == no_limit ? fitted_smooth(points, error) : fitted(points, error);
  };
  Verdict v{slope_of(&Point::position), slope_of(&Point::velocity), predicted(method, problem)};
  if (!v.predicted) return v;
  // How far below what is predicted, or above. A slope that is not a number is infinitely far off.
  const auto off = [](const Slope& slope, double least, double most) {
    return std::isfinite(slope.value) ? std::max({0.0, least - slope.value, slope.value - most}) : no_limit;
  };
  const Prediction& want = *v.predicted;
  const double room = want.most - want.position;
  v.position_gate = gate_of(v.position, want.position, method, problem);
  v.velocity_gate = gate_of(v.velocity, want.velocity, method, problem);
  v.position_line = correlation_with(v.position, scatter_on(problem));
  v.velocity_line = want.at_least ? 0 : correlation_with(v.velocity, scatter_on(problem));
  v.position_holds =
      off(v.position, want.position, want.most) <= v.position_gate && v.position.correlation >= v.position_line;
  v.velocity_holds =
      off(v.velocity, want.velocity, want.at_least ? no_limit : want.velocity + room) <= v.velocity_gate &&
      !(v.velocity.correlation < v.velocity_line);
  return v;
}

bool applies(const MethodInfo& method, const Problem& problem) { return refusal(method, *problem.system()).empty(); }

}  // namespace furrow::verification
