#include "verification/studies/order_cure.h"

#include <algorithm>
#include <cmath>

namespace furrow::verification {

std::vector<Point> observe_graded(const std::string& method, const Problem& problem, int grading,
                                  const Series& series) {
  constexpr double fewest = 80;  // steps
  // Just inside: at the touch itself the force is still that of free flight, and a step that begins with it has, where
  // the force jumps, first order again.
  const double start = problem.touch + 1e-13 * problem.unit;
  std::vector<Point> points;
  for (int size = 0; size < series.sizes; ++size) {
    const int steps = static_cast<int>(std::lround(fewest * std::pow(series.ratio, size)));
    Point point{};
    constexpr int ends = 8;
    double position = 0, velocity = 0;
    for (int k = 0; k < ends; ++k) {
      const double duration = problem.unit * (0.3 + 0.35 * (k + 0.5) / ends);
      const auto system = problem.system();
      const auto run = make_method(method);
      State y = problem.state(start);
      double t = 0;
      for (int n = 1; n <= steps; ++n) {
        const double next = duration * std::pow(static_cast<double>(n) / steps, grading);
        run->step(*system, t, y, next - t);
        t = next;
      }
      const State want = problem.state(static_cast<long double>(start) + duration);
      const std::size_t q = system->positions();
      for (std::size_t i = 0; i < q; ++i) {
        position += std::pow((y[i] - want[i]) / problem.length, 2) / static_cast<double>(q * ends);
        velocity += std::pow((y[i + q] - want[i + q]) / problem.speed, 2) / static_cast<double>(q * ends);
      }
      point.evaluations += static_cast<double>(run->evaluations()) / ends;
    }
    point.step = 0.5 * problem.unit / steps;
    point.per_step = point.evaluations / steps;
    point.position = std::sqrt(position);
    point.velocity = std::sqrt(velocity);
    points.push_back(point);
  }
  return points;
}

double predicted_graded(const MethodInfo& method, const Problem& problem, int grading) {
  const double p = method.order;
  const bool whole_power = problem.limit == std::round(problem.limit);
  return whole_power ? p : std::min(p, grading * problem.limit);
}

}  // namespace furrow::verification
