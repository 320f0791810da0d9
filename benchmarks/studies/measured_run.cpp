#include "benchmarks/studies/measured_run.h"

#include <algorithm>
#include <cmath>

#include "output/machine.h"
#include "output/schedule.h"
#include "run/run.h"

namespace furrow::benchmarks {
namespace {

// Sum over all plates; cheaper than observe(), which is not what is measured.
std::pair<double, double> force_on_plates(const System& system, double t, const State& y) {
  double x = 0;
  double height = 0;
  system.for_each_contact(t, y, [&](const Contact& c) {
    if (!of_plate(c.id.kind)) return;
    x -= c.fx;
    height -= c.fy;
  });
  return {x, height};
}

class Sampler {
 public:
  // The start is no sample: all that is compared has been run.
  Sampler(const Case& scene, const MethodInfo& method, double step, Outcome& outcome)
      : case_(scene), due_(method, step, scene.span.interval, scene.span.start), outcome_(outcome) {
    due_.restore(1);
    outcome_.reach.resize(static_cast<std::size_t>(scene.system.parts().bodies()));
  }

  double stop(double t) const { return due_.stop(t, case_.span.end()); }

  void see(const System& system, double t, const State& y) {
    if (!due_.at(t)) return;
    due_.take(t);
    if (!system.parts().plate.empty()) {
      const auto [x, height] = force_on_plates(system, t, y);
      outcome_.force.insert(outcome_.force.end(), {x, height});
    }
    for (int i = 0; i < system.parts().bodies(); ++i) {
      const double gone =
          std::hypot(y[system.x_of(i)] - case_.y[system.x_of(i)], y[system.y_of(i)] - case_.y[system.y_of(i)]);
      outcome_.reach[i] = std::max(outcome_.reach[i], gone);
    }
  }

 private:
  const Case& case_;
  Due due_;
  Outcome& outcome_;
};

// The clock is looked at now and then: that takes as long as an evaluation of a small scene.
struct Clock {
  double begun;   // s
  long next = 0;  // evaluations
  bool beyond(long evaluations, double most) {
    if (evaluations < next) return false;
    next = evaluations + 500;
    return cpu_seconds() - begun > most;
  }
};

// Per number, over `unit`; 0 if there is nothing to compare.
double difference(const std::vector<double>& a, const std::vector<double>& b, double unit) {
  if (b.empty()) return 0;
  if (a.size() != b.size()) return NAN;
  std::vector<double> difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  return root_mean_square(difference) / unit;
}

}  // namespace

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

Outcome run_case(const Case& scene, const Effort& effort) {
  Outcome outcome;
  System system = scene.system;
  State y = scene.y;
  const auto method = make_method(
      effort.method,
      {.relative = effort.tolerance, .absolute = 0.01 * effort.tolerance, .first_step = std::min(1e-4, effort.step)});
  Sampler sampler(scene, method->info(), effort.step, outcome);
  const RunPlan plan{.start = scene.span.start,
                     .end = scene.span.end(),
                     .step = effort.step,
                     .stop = [&sampler](double t) { return sampler.stop(t); },
                     .locate = effort.locate};
  const double begun = cpu_seconds();
  Clock clock{begun};
  const RunEnd end = run(system, *method, y, plan, [&](double t, const State& now, const JumpReport& jump) {
    outcome.torn += static_cast<int>(jump.torn.size());
    sampler.see(system, t, now);
    return method->evaluations() < effort.most_evaluations && !clock.beyond(method->evaluations(), effort.most_cpu);
  });
  outcome.cpu = cpu_seconds() - begun;
  outcome.reached = end.time;
  outcome.steps = end.steps;
  outcome.evaluations = method->evaluations() + end.event_evaluations;
  if (end.ending == Ending::diverged) outcome.failure = end.reason;
  if (end.ending == Ending::stopped)
    outcome.failure = "not at the end after " + std::to_string(method->evaluations()) + " evaluations";
  outcome.given_up = end.ending == Ending::stopped;
  outcome.place.assign(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(system.positions()));
  return outcome;
}

Error error_of(const Outcome& outcome, const Outcome& reference) {
  // Over the numbers of x and y each: the same root mean square over bodies in both, but for a factor sqrt(2).
  const double unit = root_mean_square(reference.reach) / std::sqrt(2.0);
  return {difference(outcome.place, reference.place, unit),
          difference(outcome.force, reference.force, root_mean_square(reference.force))};
}

}  // namespace furrow::benchmarks
