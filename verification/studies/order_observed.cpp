#include "verification/studies/order_observed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "run/run.h"

namespace furrow::verification {
namespace {

struct Plan {
  double step;   // s; of a controlled method the longest
  int steps;     // that make up the run
  double start;  // s, on the exact solution
  Locate locate = Locate::none;
  Tolerances tolerances{};
};

struct Ran {
  State y;
  long steps = 0;
  long evaluations = 0;
};

// As `run` does it, for a system that no event interrupts.
long run_plain(const OdeSystem& system, Method& method, State& y, const Plan& plan) {
  long steps = 0;
  const double end = plan.steps * plan.step;
  for (double t = 0; method.info().controlled ? t < end * (1 - 1e-12) : steps < plan.steps; ++steps) {
    t += method.step(system, plan.start + t, y, method.info().controlled ? std::min(plan.step, end - t) : plan.step);
    if (!method.info().controlled) t = static_cast<double>(steps + 1) * plan.step;
    if (!std::isfinite(y[0])) throw Divergence("not finite");
  }
  return steps;
}

// From y; a fresh method. Throws Divergence.
Ran carry(OdeSystem& system, const std::string& name, const State& start, const Plan& plan) {
  const auto method = make_method(name, plan.tolerances);
  Ran ran{start};
  if (auto* scene = dynamic_cast<System*>(&system)) {
    const double end = plan.steps * plan.step;
    const RunEnd ended =
        run(*scene, *method, ran.y, {.start = 0, .end = end, .step = plan.step, .stop = {}, .locate = plan.locate},
            [](double, const State&, const JumpReport&) { return true; });
    if (ended.ending != Ending::finished) throw Divergence(ended.reason);
    ran.steps = ended.steps;
  } else {
    ran.steps = run_plain(system, *method, ran.y, plan);
  }
  ran.evaluations = method->evaluations();
  return ran;
}

// The problem's state at `time`; a first jump gives contacts their tangential springs, which that state then fills.
State placed(OdeSystem& system, const Problem& problem, double time) {
  State y = problem.state(time);
  State room = y;
  if (auto* scene = dynamic_cast<System*>(&system)) scene->jump(0, room);
  return y;
}

double mean_square(const State& a, const State& b, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum / static_cast<double>(to - from);
}

// Quasi-random in [0, 1), evenly spread whatever the count: multiples of an irrational number.
double spread(int k, double irrational) { return std::fmod((k + 0.5) * irrational, 1.0); }

// The runs of one point. Each starts at another place within a step, with a step of its own, and ends elsewhere: else
// two events would stand in the same relation in all of them, or the error would happen to vanish at the end.
Plan jittered(const Problem& problem, double steps, int size, int phase) {
  const double step = problem.duration / (steps * (1 + 0.25 * spread(phase, 0.7548776662466927)));
  const double end = problem.duration * (1 - (1 - problem.earliest) * spread(phase, 0.5698402909980532));
  return {.step = step,
          .steps = static_cast<int>(end / step),
          .start = spread(phase + 16 * size, 0.6180339887498949) * step,
          .locate = problem.locate};
}

// Adds the runs of all phases to one point. `one` makes a run and returns what it reached and should have reached.
template <class One>
Point over_phases(const Problem& problem, const Series& series, const One& one) {
  Point point;
  double position = 0, velocity = 0, steps = 0, length = 0;
  for (int k = 0; k < series.phases; ++k) {
    try {
      const auto system = problem.system();
      const auto [ran, want, duration] = one(*system, k);
      const std::size_t q = system->positions();
      position += mean_square(ran.y, want, 0, q);
      velocity += mean_square(ran.y, want, q, 2 * q);
      point.evaluations += static_cast<double>(ran.evaluations);
      steps += static_cast<double>(ran.steps);
      length += duration;
    } catch (const Divergence&) {
      ++point.failures;
    }
  }
  const int good = series.phases - point.failures;
  point.position = std::sqrt(position / good) / problem.length;
  point.velocity = std::sqrt(velocity / good) / problem.speed;
  point.per_step = point.evaluations / steps;
  point.evaluations /= good;
  point.step = length / steps;
  return point;
}

// High orders reach round-off soon: their steps lie closer.
double steps_of(const std::string& method, const Problem& problem, const Series& series, int size) {
  const double order = std::min<double>(make_method(method)->info().order, problem.limit);
  return problem.least_steps * std::pow(series.ratio, size * std::min(1.0, 3 / order));
}

// A point of a fit.
struct Place {
  double x, step, y;  // log of the abscissa, s, log of the error
};

// Takes the mean away and returns it.
double centre(std::vector<Place>& places, double Place::*what) {
  double mean = 0;
  for (const Place& p : places) mean += p.*what / static_cast<double>(places.size());
  for (Place& p : places) p.*what -= mean;
  return mean;
}

double product(const std::vector<Place>& places, double Place::*one, double Place::*other) {
  double sum = 0;
  for (const Place& p : places) sum += p.*one * p.*other;
  return sum;
}

bool is_controlled(const std::string& method) { return make_method(method)->info().controlled; }

}  // namespace

Slope fitted_return(const std::vector<Point>& points) {
  return fitted(points, &Point::position, 6, &Point::step, 1e-12);
}

Slope fitted_smooth(const std::vector<Point>& points, double Point::*error) {
  return fitted(points, error, 6, &Point::step, 1e-12);
}

Slope fitted(const std::vector<Point>& points, double Point::*error, int most, double Point::*abscissa,
             double round_off) {
  std::vector<Place> places;
  for (auto p = points.rbegin(); p != points.rend() && static_cast<int>(places.size()) < most; ++p) {
    if (p->failures == 0 && (*p).*error > round_off && (*p).*error < 1.0 / 30)
      places.push_back({std::log((*p).*abscissa), p->step, std::log((*p).*error)});
  }
  Slope slope;
  slope.points = static_cast<int>(places.size());
  if (slope.points < 4) return {NAN, NAN, NAN, NAN, NAN, slope.points};
  centre(places, &Place::x);
  slope.step = centre(places, &Place::step);
  centre(places, &Place::y);
  const double xx = product(places, &Place::x, &Place::x), xy = product(places, &Place::x, &Place::y);
  const double hh = product(places, &Place::step, &Place::step), hx = product(places, &Place::step, &Place::x);
  const double hy = product(places, &Place::step, &Place::y), yy = product(places, &Place::y, &Place::y);
  slope.value = xy / xx;
  slope.correlation = xy / std::sqrt(xx * yy);
  slope.spread = xx;
  slope.error = std::sqrt(std::max(0.0, yy - slope.value * xy) / (slope.points - 2) / xx);
  const double with_next = (xy * hh - hy * hx) / (xx * hh - hx * hx);
  slope.next = std::fabs(with_next - slope.value);
  return slope;
}

double correlation_with(const Slope& slope, double scatter) {
  const double on_the_line = slope.value * slope.value * slope.spread;
  return std::sqrt(on_the_line / (on_the_line + (slope.points - 2) * scatter * scatter));
}

double tolerance_of(const Slope& slope) {
  // Student's t for 99.73 %, by degrees of freedom from 2 on; JCGM 100:2008, table G.2.
  constexpr std::array<double, 9> t{19.21, 9.22, 6.62, 5.51, 4.90, 4.53, 4.28, 4.09, 3.96};
  if (slope.points < 4) return NAN;
  return std::max(0.05, t[std::min<std::size_t>(slope.points - 4, t.size() - 1)] * slope.error + 2 * slope.next);
}

Slope fitted_exponent(const std::vector<Point>& points) {
  std::vector<Point> ruled;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k + 1 == points.size() || points[k].step > 1.03 * points[k + 1].step) ruled.push_back(points[k]);
  }
  return fitted(ruled, &Point::position, 99, &Point::tolerance);
}

double planned_tolerance(const Series& series, int size) {
  return 1e-5 * std::pow(1e-5, static_cast<double>(size) / (series.sizes - 1));
}

std::vector<Point> observe(const std::string& method, const Problem& problem, const Series& series) {
  std::vector<Point> points;
  const bool controlled = is_controlled(method);
  for (int size = 0; size < series.sizes; ++size) {
    Tolerances tolerances;
    if (controlled) {
      tolerances.relative = planned_tolerance(series, size);
      tolerances.absolute = tolerances.relative * problem.length;
      tolerances.first_step = problem.duration / 1000;
    }
    points.push_back(over_phases(problem, series, [&](OdeSystem& system, int phase) {
      // The longest step of a controlled method; on events short, or it might step over a whole contact.
      const double fewest = problem.limit == no_limit ? 2 : 10;
      Plan plan = jittered(problem, controlled ? fewest : steps_of(method, problem, series, size),
                           controlled ? 0 : size, phase);
      plan.tolerances = tolerances;
      const Ran ran = carry(system, method, placed(system, problem, plan.start), plan);
      return std::tuple(ran, problem.state(plan.start + plan.steps * static_cast<long double>(plan.step)),
                        plan.steps * plan.step);
    }));
    points.back().tolerance = controlled ? tolerances.relative : 0;
  }
  return points;
}

double planned_step(const std::string& method, const Problem& problem, const Series& series, int size) {
  double steps = 0, length = 0;
  for (int k = 0; k < series.phases; ++k) {
    const Plan plan = jittered(problem, steps_of(method, problem, series, size), size, k);
    steps += plan.steps;
    length += plan.steps * plan.step;
  }
  return length / steps;
}

std::vector<Point> observe_return(const std::string& method, const Problem& problem, const Series& series) {
  std::vector<Point> points;
  for (int size = 0; size < series.sizes; ++size) {
    points.push_back(over_phases(problem, series, [&](OdeSystem& system, int phase) {
      const Plan plan = jittered(problem, steps_of(method, problem, series, size), size, phase);
      const State start = placed(system, problem, plan.start);
      const auto reverse = [&](State& y) {
        for (std::size_t i = system.positions(); i < 2 * system.positions(); ++i) y[i] = -y[i];
      };
      Ran there = carry(system, method, start, plan);
      reverse(there.y);
      Ran back = carry(system, method, there.y, plan);
      reverse(back.y);
      return std::tuple(back, start, plan.steps * plan.step);
    }));
  }
  return points;
}

}  // namespace furrow::verification
