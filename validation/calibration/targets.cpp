#include "validation/calibration/targets.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "report/seal.h"
#include "scene/wording.h"
#include "validation/page/observables.h"

namespace furrow::validation {
namespace {

// Of one number, in tolerances; a limit that is kept misses by nothing.
double residual(const CalibrationTarget& t, double value) {
  const double off = value - t.value[0];
  if (t.relation == Relation::below) return std::max(0.0, off) / t.tolerance;
  if (t.relation == Relation::above) return std::min(0.0, off) / t.tolerance;
  if (t.relation == Relation::between) return (std::min(0.0, off) + std::max(0.0, value - t.value[1])) / t.tolerance;
  return off / t.tolerance;
}

// Whether the plate goes through all of it, and there are samples: the last is within an interval of the end.
bool covers(const RunRecord& run, double from, double to) {
  const std::vector<double>& mm = run.force.mm;
  if (mm.empty() || from < mm.front()) return false;
  const double interval = mm.size() > 1 ? mm.back() - mm[mm.size() - 2] : 0;
  return to <= mm.back() + interval && to <= plate_displacement(run, run.scene.time.end) * (1 + 1e-9);
}

// Linear between two samples that cover it.
double force_at(const std::vector<double>& mm, const std::vector<double>& force, double at) {
  const auto after = std::lower_bound(mm.begin(), mm.end(), at) - mm.begin();
  if (after == std::ssize(mm)) return force.back();
  if (after == 0) return force.front();
  const double share = (at - mm[after - 1]) / (mm[after] - mm[after - 1]);
  return force[after - 1] + share * (force[after] - force[after - 1]);
}

Json curve_of(const MeasuredCurve& curve, const RunRecord& run) {
  const ForceCurve& ours = run.force;
  const std::vector<double>& force = curve.component == "Fx" ? ours.fx : curve.component == "Fy" ? ours.fy : ours.f;
  if (!covers(run, curve.mm.front(), curve.mm.back())) return nullptr;
  Json values = Json::array();
  for (const double mm : curve.mm) {
    const double f = force_at(ours.mm, force, mm);
    if (!std::isfinite(f)) return nullptr;
    values.push_back(std::stod(rounded(f, 8)));
  }
  return values;
}

double norm_of(CurveNorm norm, const std::vector<double>& off) {
  double sum = 0, greatest = 0;
  for (const double r : off) {
    sum += norm == CurveNorm::rms ? r * r : std::fabs(r);
    greatest = std::max(greatest, std::fabs(r));
  }
  if (norm == CurveNorm::max) return greatest;
  const double mean = sum / static_cast<double>(off.size());
  return norm == CurveNorm::rms ? std::sqrt(mean) : mean;
}

std::string hash_of_numbers(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += shortest(number) + " ";
  return hash_of(text);
}

}  // namespace

std::string CalibrationTarget::asked() const {
  std::vector<std::string> parts{observable};
  if (relation == Relation::says) parts.emplace_back("in words");
  if (window) parts.push_back(shortest((*window)[0]) + " to " + shortest((*window)[1]));
  if (curve) {
    parts.push_back(curve->component);
    parts.push_back(hash_of_numbers(curve->mm));  // the numbers themselves would stand in each kept run
  }
  return joined(parts, " ");
}

Json value_of(const CalibrationTarget& target, const RunRecord& run) {
  if (target.curve) return curve_of(*target.curve, run);
  if (target.window && !covers(run, (*target.window)[0], (*target.window)[1])) return {};
  const Measured measured = measure(run, target.observable, target.window);
  if (target.relation == Relation::says && !measured.words.empty()) return measured.words;
  if (std::isfinite(measured.value)) return measured.value;
  return measured.words.empty() ? Json() : Json(measured.words);
}

bool comparable(const CalibrationTarget& target, const Json& value) {
  if (target.curve) return value.is_array() && value.size() == target.curve->mm.size();
  return target.relation == Relation::says ? !value.is_null() : value.is_number();
}

std::vector<double> residuals(const CalibrationTarget& target, const Json& value, double missing) {
  if (target.relation == Relation::says && !target.curve) return {value == target.words ? 0.0 : 1.0};
  const std::size_t count = target.curve ? target.curve->mm.size() : 1;
  if (!comparable(target, value)) return std::vector<double>(count, missing);
  if (!target.curve) return {residual(target, value)};
  std::vector<double> off;
  for (std::size_t k = 0; k < count; ++k)
    off.push_back((value[k].get<double>() - target.curve->force[k]) / target.tolerance);
  return off;
}

double misfit(const CalibrationTarget& target, const Json& value, double missing) {
  return norm_of(target.curve ? target.curve->norm : CurveNorm::rms, residuals(target, value, missing));
}

double misfit(const Targets& targets, const Json& values) {
  double sum = 0, weights = 0;
  for (std::size_t k = 0; k < targets.all.size(); ++k) {
    const double r = misfit(targets.all[k], values.at(k), targets.missing);
    sum += targets.all[k].weight * (targets.bounded ? r * r / (1 + r * r) : r * r);
    weights += targets.all[k].weight;
  }
  return std::sqrt(sum / weights);
}

double number_of(const Json& value) {
  if (value.is_number()) return value;
  if (!value.is_array()) return NAN;
  double sum = 0;
  for (const Json& force : value) sum += force.get<double>();
  return sum / static_cast<double>(value.size());
}

}  // namespace furrow::validation
