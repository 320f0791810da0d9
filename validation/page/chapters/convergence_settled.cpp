#include "validation/page/chapters/convergence_settled.h"

#include <algorithm>
#include <cmath>

#include "output/files.h"

namespace furrow::validation {
namespace {

constexpr double agreement = 0.02;  // of a number: what "the same" means where nothing is chaotic

}  // namespace

bool measured(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c) {
  const std::vector<ConvergenceRun> runs = plan.runs();
  return std::all_of(runs.begin(), runs.end(), [&](const ConvergenceRun& one) {
    return one.of.name() != c.name() || results.find(one.key()) != nullptr;
  });
}

double energy_made(const Numbers& results, const ConvergenceRun& one) {
  const Result* booked = results.find(one.energy_key());
  return booked == nullptr || booked->failed() ? NAN : booked->value.at("made").get<double>();
}

std::string instability_words(const Numbers& results, const ConvergenceRun& one) {
  const double made = energy_made(results, one);
  return made > 1 ? "the method makes " + three_digits(made) + " times all the energy that the scene was given" : "";
}

std::string in_ms(double step) { return number(std::round(1e7 * step) / 1e4) + " ms"; }

bool failed(const Numbers& results, const ConvergenceRun& one) {
  const Json& got = results.at(one.key());
  return !got.contains("values") || got["ended"] != "finished";
}

double value_in(const Numbers& results, const ConvergenceRun& one, const std::string& id) {
  if (failed(results, one)) return NAN;
  const Json& values = results.at(one.key())["values"];
  return values.contains(id) ? values[id].get<double>() : NAN;
}

Json forces_by_step(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c,
                    const std::string& id) {
  Json rows = Json::array();
  for (const double step : plan.steps) {
    const double value = value_in(results, {c, "pece", step}, id);
    if (std::isfinite(value)) rows.push_back({1e3 * step, value});
  }
  return rows;
}

double settled_from(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c,
                    const std::string& id, double spread) {
  const double finest = value_in(results, {c, "pece", plan.steps.back()}, id);
  const double allowed = std::max(spread, agreement * std::fabs(finest));
  double from = NAN;
  for (auto step = plan.steps.rbegin() + 1; step != plan.steps.rend(); ++step) {
    if (!(std::fabs(value_in(results, {c, "pece", *step}, id) - finest) <= allowed)) break;
    if (!instability_words(results, {c, "pece", *step}).empty()) break;  // the same number is then a coincidence
    from = *step;
  }
  for (const std::string& method : plan.others) {
    if (!(std::fabs(value_in(results, {c, method, plan.others_step}, id) - finest) <= allowed)) return NAN;
  }
  return from;
}

double spread_of(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c, const std::string& id) {
  const double base = value_in(results, {c, "pece", plan.nudged_step}, id);
  double spread = 0;
  for (int n = 1; n <= plan.nudged_runs; ++n)
    spread = std::max(spread, std::fabs(value_in(results, {c, "pece", plan.nudged_step, n}, id) - base));
  return spread;
}

std::string step_words(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c,
                       const std::string& id) {
  const double papers = value_in(results, {c, "pece", papers_step}, id),
               finest = value_in(results, {c, "pece", plan.steps.back()}, id);
  if (!std::isfinite(papers) || !std::isfinite(finest)) return {};
  const double from = settled_from(results, plan, c, id, spread_of(results, plan, c, id));
  if (from >= papers_step) return "does not depend on the step";
  const std::string unstable = instability_words(results, {c, "pece", papers_step});
  return "depends on the step: " + three_digits(papers) + " at " + in_ms(papers_step) +
         (unstable.empty() ? "" : ", by which the method makes more than all the energy that there is") + ", " +
         three_digits(finest) + " at " + in_ms(plan.steps.back());
}

}  // namespace furrow::validation
