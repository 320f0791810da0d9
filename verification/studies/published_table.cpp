#include "verification/studies/published_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "verification/studies/order_predicted.h"

namespace furrow::verification {
namespace {

constexpr int sizes = 13, tolerances = 17;
constexpr double ratio = 1.45;
constexpr long most_steps = 6'000'000;  // half a second

double greatest(const State& y) {
  double most = 0;
  for (const double v : y) most = std::max(most, std::fabs(v));
  return most;
}

// Of the whole state; infinite where it is no number.
double distance(const State& y, const State& want) {
  double most = 0;
  for (std::size_t i = 0; i < y.size(); ++i)
    most = std::isfinite(y[i]) ? std::max(most, std::fabs(y[i] - want[i])) : no_limit;
  return most;
}

// Steps of h from `from` to `to`, or those that a controlled method chooses. Returns how many.
long carried(const OdeSystem& system, Method& method, State& y, double from, double to, long steps) {
  const double h = (to - from) / static_cast<double>(steps);
  long taken = 0;
  if (!method.info().controlled) {
    for (; taken < steps; ++taken) method.step(system, from + static_cast<double>(taken) * h, y, h);
    return taken;
  }
  for (double t = from; t < to - 1e-13 * to; ++taken) t += method.step(system, t, y, to - t);
  return taken;
}

double judged_at(const PublishedProblem& problem) { return problem.judged > 0 ? problem.judged : problem.end; }

// Where a jump is located the method is told, and each piece has its own right-hand side up to its end.
Point point(const PublishedProblem& problem, const State& want, Method& method, long steps, double scale) {
  PublishedSystem system(problem);
  State y = problem.start;
  const double end = judged_at(problem);
  const int pieces = problem.located ? static_cast<int>(end) : 1;
  Point result;
  long taken = 0;
  try {
    for (int k = 0; k < pieces; ++k) {
      if (problem.located) system.hold(k);
      method.restart();
      taken += carried(system, method, y, k * end / pieces, (k + 1) * end / pieces, steps / pieces);
    }
  } catch (const Divergence&) {
    result.failures = 1;
  }
  result.step = end / static_cast<double>(std::max(1L, taken));
  result.position = distance(y, want) / scale;
  result.failures += std::isfinite(result.position) ? 0 : 1;
  return result;
}

// Where f jumps a power of two each second, so that whole t are hit without round-off.
long steps_of(const MethodInfo& method, const PublishedProblem& problem, int size) {
  if (problem.jumps) return static_cast<long>(problem.end) << (size / 2 + std::max(3, 7 - method.order));
  const long least = problem.least_steps * (method.order == 1   ? problem.order_one
                                            : method.order == 2 ? problem.order_two
                                                                : 1L);
  return std::lround(static_cast<double>(least) * std::pow(ratio, size));
}

std::vector<Point> fixed_points(const MethodInfo& method, const PublishedProblem& problem, const State& want) {
  const double scale = greatest(want);
  std::vector<Point> points;
  for (int size = 0; size < sizes; ++size) {
    if (problem.jumps && size % 2 != 0) continue;
    const auto fresh = make_method(method.name);
    const long steps = steps_of(method, problem, size);
    if (steps <= most_steps) points.push_back(point(problem, want, *fresh, steps, scale));
  }
  return points;
}

// From 1e-4 to 1e-12; to 1e-8 with a Jacobian by differences, whose error is the root of round-off.
std::vector<Point> controlled_points(const MethodInfo& method, const PublishedProblem& problem, const State& want) {
  std::vector<Point> points;
  const double scale = greatest(want);
  for (int k = 0; k < tolerances; ++k) {
    const double tolerance = std::pow(10, -4 - (method.dense_jacobian ? 4.0 : 8.0) * k / (tolerances - 1));
    const auto fresh = make_method(
        method.name, {.relative = tolerance, .absolute = tolerance * scale, .first_step = 1e-3 * problem.end});
    points.push_back(point(problem, want, *fresh, 1, scale));
    points.back().tolerance = tolerance;
  }
  return points;
}

// Every method asks for it.
const State& solution(const PublishedProblem& problem) {
  static std::mutex mutex;
  static std::map<std::string, State> known;
  const std::scoped_lock lock(mutex);
  const auto found = known.find(problem.name);
  return found != known.end() ? found->second
                              : known.emplace(problem.name, extrapolated(problem, judged_at(problem))).first->second;
}

std::string reason_against(const MethodInfo& method, const PublishedProblem& problem) {
  if (!refusal(method, PublishedSystem(problem)).empty()) return "takes q'' = f(t, q) only";
  if (!method.controlled && method.order == 1 && problem.order_one == 0)
    return "of first order, would need more steps for " + problem.name + " than can be afforded";
  return {};
}

// The next power of the step, which moves the slope by `next`, takes the points off the line by a fifth of that, and the
// powers after it by as much again. Of P(EC)E it may have the larger factor, and of order 5 it may rule down to where
// round-off begins: up to order p + 1 then.
void judge_fixed(PublishedCell& cell, const MethodInfo& method, const PublishedProblem& problem) {
  cell.slope = fitted(cell.points, &Point::position, 6, &Point::step, problem.floor);
  cell.least = cell.most = problem.jumps && !problem.located ? 1 : method.order;
  if (cell.most >= 5 || (predictors_share(method) > 0 && cell.most > 1)) cell.most += 1;
  cell.gate = std::min(tolerance_of(cell.slope), 0.5);
  cell.line = correlation_with(cell.slope, 0.03 + 0.5 * cell.slope.next);
}

// One run a tolerance has luck or not: a cut last step, an error that passes through zero, a step that is five times as
// long. That the exponent is right to a third, over so many decades, no luck can bring about. Steps over jumps may
// happen to hit one: a lower bound. Runs of fewer than ten steps follow no tolerance, but keep it.
void judge_controlled(PublishedCell& cell, const MethodInfo& method, const PublishedProblem& problem) {
  const bool over_jumps = problem.jumps && !problem.located;
  const double longest = (problem.located ? 1 : judged_at(problem)) / 10;
  Problem force;
  force.limit = over_jumps ? 1 : no_limit;
  std::vector<Point> followed = cell.points;
  std::erase_if(followed, [&](const Point& p) { return p.step > longest; });
  cell.few_steps = followed.size() < tolerances / 2 + 1;
  cell.slope = fitted(followed, &Point::position, tolerances, &Point::tolerance, problem.floor);
  const Exponents want = predicted_exponents(method, force);
  cell.least = over_jumps ? want.with_event : want.smooth;
  cell.most = over_jumps ? no_limit : want.smooth;
  cell.gate = 1.0 / 3;
  cell.line = correlation_with(cell.slope, over_jumps ? 3 : std::log(5.0));
}

}  // namespace

PublishedCell published_cell(const MethodInfo& method, const PublishedProblem& problem) {
  PublishedCell cell{.cannot = reason_against(method, problem)};
  if (!cell.cannot.empty()) return cell;
  const State& want = solution(problem);
  cell.points = method.controlled ? controlled_points(method, problem, want) : fixed_points(method, problem, want);
  method.controlled ? judge_controlled(cell, method, problem) : judge_fixed(cell, method, problem);
  const auto below = [&](const Point& p) { return p.failures == 0 && p.position < problem.floor; };
  const auto kept = [](const Point& p) { return p.failures == 0 && p.position < 100 * p.tolerance; };
  // Too few errors, or of too many powers of the step, above round-off.
  const bool unresolved = !method.controlled && !(tolerance_of(cell.slope) <= 0.5);
  const bool follows = cell.slope.value >= cell.least - cell.gate && cell.slope.value <= cell.most + cell.gate &&
                       cell.slope.correlation >= cell.line;
  cell.at_floor =
      unresolved && !follows && cell.points.size() >= 3 && std::all_of(cell.points.end() - 3, cell.points.end(), below);
  cell.holds = cell.at_floor || (cell.few_steps ? std::all_of(cell.points.begin(), cell.points.end(), kept) : follows);
  return cell;
}

bool known_to_fail(const MethodInfo& method, const PublishedProblem& problem) {
  return method.name == "odeint_fehlberg78" && problem.jumps && !problem.located;
}

}  // namespace furrow::verification
