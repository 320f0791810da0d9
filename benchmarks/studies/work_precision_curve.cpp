#include "benchmarks/studies/work_precision_curve.h"

#include <algorithm>
#include <cmath>

namespace furrow::benchmarks {
namespace {

constexpr double paper_step = 1e-4;  // s: one of the steps of every curve
constexpr int least_repeats = 3, most_repeats = 9;
constexpr double worth_repeating = 0.05, long_enough = 1.0;  // s of CPU
constexpr double cold_start = 5e-3;  // s: of shorter runs the first one warms the caches and is not counted

// At fixed steps an event falls into the same place of its step again and again; neighbouring steps spread it.
std::vector<Effort> phases_of(const Effort& effort, const CaseInfo& info, const Case& scene, bool controlled) {
  std::vector<Effort> all{effort};
  const long n = std::lround(scene.span.interval / effort.step);
  for (int k = 1; k < info.phases; ++k) {
    const long off = (k % 2 == 1 ? 1 : -1) * ((k + 1) / 2) * std::max(1L, std::lround(0.06 * static_cast<double>(n)));
    if (!controlled && n + off < 8) break;
    all.push_back(effort);
    all.back().step = controlled ? effort.step : scene.span.interval / static_cast<double>(n + off);
    all.back().tolerance *= k % 2 == 1 ? 0.7 : 1.4;
  }
  return all;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

WorkPrecisionPoint measured(const std::vector<Effort>& phases, const Case& scene, const Reference& reference) {
  WorkPrecisionPoint point;
  std::vector<double> cpu;
  std::vector<long> evaluations;
  double spent = 0;
  const double runs = static_cast<double>(phases.size());
  for (std::size_t k = 0; k < most_repeats; ++k) {
    const bool again = k >= phases.size();
    if (again && k >= least_repeats && spent > worth_repeating) break;
    if (again && spent > long_enough) break;
    const Outcome outcome = run_case(scene, phases[k % phases.size()]);
    spent += outcome.cpu;
    cpu.push_back(outcome.cpu);
    if (again) {
      if (outcome.evaluations != evaluations[k % phases.size()]) throw std::logic_error("a repeated run differs");
      continue;
    }
    const Error error = error_of(outcome, reference.outcome);
    point.failure = outcome.failure;
    point.given_up = outcome.given_up;
    if (point.failure.empty() && !std::isfinite(error.place + error.force))
      point.failure = "an error that is not finite";
    if (!point.failure.empty()) {
      point.evaluations = static_cast<double>(outcome.evaluations);
      break;
    }
    evaluations.push_back(outcome.evaluations);
    point.evaluations += static_cast<double>(outcome.evaluations) / runs;
    point.error.place += error.place * error.place / runs;
    point.error.force += error.force * error.force / runs;
  }
  point.error = {std::sqrt(point.error.place), std::sqrt(point.error.force)};
  if (cpu.size() > 1 && cpu.front() < cold_start) cpu.erase(cpu.begin());
  point.cpu = median(cpu);
  point.cpu_least = *std::min_element(cpu.begin(), cpu.end());
  point.cpu_most = *std::max_element(cpu.begin(), cpu.end());
  return point;
}

bool below(const Error& error, const Error& floor) { return error.place < floor.place && error.force <= floor.force; }

std::vector<double> settings_of(const CaseInfo& info, bool controlled) {
  std::vector<double> all;
  if (controlled) {
    for (int k = -1; k <= 12; ++k) all.push_back(std::pow(10.0, -k));
  } else {
    double h = paper_step;
    while (h * 2 <= info.coarsest) h *= 2;
    for (; h >= info.finest; h /= 2) all.push_back(h);
  }
  return all;
}

// Of a fixed-step run that failed: evaluations if it had come to its end.
double nominal_evaluations(const MethodInfo& method, const Case& scene, double step) {
  return (scene.span.end() - scene.span.start) / step * method.evaluations;
}

}  // namespace

WorkPrecisionCurve measure_curve(const Variant& variant, const CaseInfo& info, const Case& scene,
                                 const Reference& reference) {
  const MethodInfo& method = variant.method;
  WorkPrecisionCurve method_curve{.method = method.name, .locate = variant.locate};
  const double length = scene.span.end() - scene.span.start;
  const long most = std::lround(4 * length / info.finest);
  for (const double setting : settings_of(info, method.controlled)) {
    Effort effort{.method = method.name,
                  .step = scene.span.interval,
                  .locate = variant.locate,
                  .most_evaluations = most,
                  .most_cpu = 3};
    if (method.controlled) {
      effort.tolerance = setting;
    } else {
      // The next step that divides the interval between samples.
      effort.step = scene.span.interval / std::max(1.0, std::round(scene.span.interval / setting));
      if (nominal_evaluations(method, scene, effort.step) > static_cast<double>(most)) break;
    }
    WorkPrecisionPoint point;
    try {
      point = measured(phases_of(effort, info, scene, method.controlled), scene, reference);
    } catch (const std::invalid_argument& reason) {
      method_curve.left_out = reason.what();
      break;
    }
    point.setting = method.controlled ? setting : effort.step;
    if (point.given_up && !method.controlled && !method_curve.points.empty()) break;
    if (!point.failure.empty() && !point.given_up && !method.controlled)
      point.evaluations = nominal_evaluations(method, scene, effort.step);
    method_curve.points.push_back(point);
    if (point.given_up || (point.failure.empty() && below(point.error, reference.floor()))) break;
  }
  return method_curve;
}

// A point is [setting, evaluations, error of the places, of the force, CPU time in the middle, least, most], or [setting,
// evaluations, why it failed].
Json json_of(const WorkPrecisionCurve& method_curve) {
  Json points = Json::array();
  for (const WorkPrecisionPoint& p : method_curve.points) {
    Json one{to_digits(p.setting, 6), to_digits(p.evaluations, 6)};
    if (p.failure.empty()) {
      for (const double value : {p.error.place, p.error.force}) one.push_back(to_digits(value, 4));
      for (const double value : {p.cpu, p.cpu_least, p.cpu_most}) one.push_back(to_digits(value, 3));
    } else {
      one.push_back(p.failure);
    }
    points.push_back(one);
  }
  if (!method_curve.left_out.empty()) return {{"left_out", method_curve.left_out}};
  return {{"points", points}};
}

WorkPrecisionCurve curve_from(const Variant& variant, const Json& json) {
  WorkPrecisionCurve curve{.method = variant.method.name,
                           .locate = variant.locate,
                           .left_out = json.value("left_out", json.value("failed", ""))};
  for (const Json& p : json.value("points", Json::array())) {
    WorkPrecisionPoint point{.setting = p.at(0), .evaluations = p.at(1)};
    if (p.at(2).is_string()) {
      point.failure = p.at(2);
    } else {
      point.error = {p.at(2), p.at(3)};
      point.cpu = p.at(4);
      point.cpu_least = p.at(5);
      point.cpu_most = p.at(6);
    }
    curve.points.push_back(point);
  }
  return curve;
}

double cost_at(const WorkPrecisionCurve& method_curve, double error, bool by_force, double WorkPrecisionPoint::*cost) {
  double reached = NAN;
  for (std::size_t k = method_curve.points.size(); k-- > 0;) {
    const WorkPrecisionPoint& p = method_curve.points[k];
    if (!p.failure.empty() && std::isnan(reached)) continue;  // given up at the fine end
    if (!p.failure.empty()) break;
    if (p.error_by(by_force) <= error) {
      reached = p.*cost;
      continue;
    }
    if (std::isnan(reached)) return reached;
    const WorkPrecisionPoint& finer = method_curve.points[k + 1];
    const double at =
        std::log(p.error_by(by_force) / error) / std::log(p.error_by(by_force) / finer.error_by(by_force));
    return p.*cost * std::pow(finer.*cost / p.*cost, at);
  }
  return reached;
}

}  // namespace furrow::benchmarks
