#include "validation/calibration/identify.h"

#include <algorithm>
#include <cmath>

#include "scene/wording.h"
#include "validation/calibration/linear_theory.h"
#include "validation/calibration/probes.h"

namespace furrow::validation {
namespace {

using Vector = Eigen::VectorXd;

constexpr double first_probe = 0.05, least_probe = 0.005;  // of a range, each way
constexpr double least_move = 1e-6;                        // of a range: a shorter step is not worth a run
constexpr int rounds = 2;                                  // the second probes about as far as the first interval

constexpr const char* unsaid_nearby =
    "at the best setting or close to it a run failed, or does not say every target: there is no slope";

Known known_of(const VariedKey& key, const std::string& value, double half, bool arrived) {
  const double share = key.share_of(value);
  Known known{key.name, value, "", ""};
  known.at_edge = share < 1e-3 || share > 1 - 1e-3;
  known.arrived = arrived;
  if (half > 0.5 || !arrived) return known;
  known.low = key.below(value, half);
  known.high = key.above(value, half);
  if (known.low == known.high) known.low.clear(), known.high.clear();  // no interval has no width
  return known;
}

// Over what was probed of that key.
double bend_over(const Evaluator& evaluator, const Point& best, const Probe& probe, const Slopes& about,
                 Eigen::Index key) {
  const double at = (about.from[key] - probe.below) / probe.width();
  return bend(residuals_of(evaluator, probe.low), residuals_of(evaluator, best), residuals_of(evaluator, probe.high),
              at, about.weights);
}

// As far along a direction as the ranges allow, by sign.
double reach_along(const Vector& from, const Vector& direction, double sign) {
  double reach = 2;
  for (Eigen::Index k = 0; k < from.size(); ++k) {
    const double step = sign * direction[k];
    if (std::fabs(step) < 1e-6) continue;
    reach = std::min(reach, (step > 0 ? 1 - from[k] : -from[k]) / step);
  }
  return std::max(0.0, reach);
}

Flat flat_along(const Evaluator& evaluator, const Point& best, const std::vector<std::size_t>& ranged,
                const Vector& direction, const Packings& packings) {
  Vector from(direction.size());
  for (std::size_t i = 0; i < ranged.size(); ++i)
    from[static_cast<Eigen::Index>(i)] = evaluator.keys()[ranged[i]].share_of(best.setting[ranged[i]]);
  Flat flat{{direction.data(), direction.data() + direction.size()}, best.misfit()};
  flat.from = -reach_along(from, direction, -1);
  flat.to = reach_along(from, direction, 1);
  std::vector<Setting> ends;
  for (const double at : {flat.from, flat.to}) {
    ends.push_back(best.setting);
    for (std::size_t i = 0; i < ranged.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      ends.back()[ranged[i]] = evaluator.keys()[ranged[i]].at(std::clamp(from[k] + at * direction[k], 0.0, 1.0));
    }
  }
  const std::vector<Point> points = evaluator.at(ends, packings);
  flat.backward = points[0].misfit();
  flat.forward = points[1].misfit();
  return flat;
}

// Difference of two points of the same packings in each target, times `scale`.
Effect effect_of(const Evaluator& evaluator, const Point& low, const Point& high, double scale) {
  Effect effect;
  const auto packings = static_cast<double>(low.values.size());
  require_values(high, evaluator.targets(), static_cast<int>(low.values.size()));
  for (std::size_t k = 0; k < evaluator.targets().all.size(); ++k) {
    double sum = 0, squares = 0;
    for (std::size_t p = 0; p < low.values.size(); ++p) {
      const double off = scale * (number_of(high.values[p][k]) - number_of(low.values[p][k]));
      sum += off;
      squares += off * off;
    }
    const double mean = sum / packings;
    effect.effect.push_back(mean);
    effect.error.push_back(packings < 2 ? NAN
                                        : std::sqrt(std::max(0.0, squares / packings - mean * mean) / (packings - 1)));
  }
  return effect;
}

void add_listed_effects(Identified& found, const Evaluator& evaluator, const Point& best, const Packings& packings) {
  std::vector<Setting> settings;
  std::vector<std::size_t> keys;
  for (std::size_t k = 0; k < evaluator.keys().size(); ++k) {
    for (const std::string& value : evaluator.keys()[k].values) {
      if (value == best.setting[k]) continue;
      settings.push_back(best.setting);
      settings.back()[k] = value;
      keys.push_back(k);
    }
  }
  const std::vector<Point> points = evaluator.at(settings, packings);
  for (std::size_t i = 0; i < points.size(); ++i) {
    found.effects.push_back(effect_of(evaluator, best, points[i], 1));
    found.effects.back().key = evaluator.keys()[keys[i]].name;
    found.effects.back().change = best.setting[keys[i]] + " to " + settings[i][keys[i]];
    found.effects.back().misfit = points[i].misfit() - best.misfit();
  }
}

void add_ranged_effects(Identified& found, const Evaluator& evaluator, const Point& best,
                        const std::vector<Probe>& probes) {
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const VariedKey& key = evaluator.keys()[ranged_keys(evaluator)[i]];
    found.effects.push_back(effect_of(evaluator, probes[i].low, probes[i].high, 0.1 / probes[i].width()));
    found.effects.back().key = key.name;
    found.effects.back().change = key.logarithmic ? "times " + rounded(std::pow(key.high / key.low, 0.1), 3)
                                                  : "+ " + rounded(0.1 * (key.high - key.low), 3);
    found.effects.back().misfit = std::max(probes[i].low.misfit(), probes[i].high.misfit()) - best.misfit();
  }
}

}  // namespace

std::string interval_of(const Known& known) {
  if (!known.arrived) return not_a_minimum;
  return known.low.empty() ? "not identifiable" : known.low + " to " + known.high;
}

std::string words_of(const Known& known) {
  const bool has_interval = known.arrived && !known.low.empty();
  return known.key + " = " + known.value + ", " + (has_interval ? "95 % interval " : "") + interval_of(known) +
         (known.at_edge ? std::string("; it is ") + at_the_edge : "");
}

std::optional<Point> stepped(const Evaluator& evaluator, const Point& best, const Packings& packings) {
  require_values(best, evaluator.targets(), packings.count);
  const std::vector<std::size_t> ranged = ranged_keys(evaluator);
  if (ranged.empty() || residuals_of(evaluator, best).size() < std::ssize(ranged)) return {};
  const Vector reach = Vector::Constant(std::ssize(ranged), least_probe);
  const std::vector<Probe> probes = probes_of(evaluator, best, ranged, reach, packings);
  if (!all_whole(best, probes)) return {};
  const Slopes about = of_loss(evaluator, slopes_about(evaluator, best, ranged, probes));
  const Vector step = step_within_ranges(about);
  if (step.cwiseAbs().maxCoeff() < least_move) return {};
  Point point;
  const auto misfit_after = [&](double share) {
    Setting setting = best.setting;
    for (std::size_t i = 0; i < ranged.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      setting[ranged[i]] = evaluator.keys()[ranged[i]].at(std::clamp(about.from[k] + share * step[k], 0.0, 1.0));
    }
    point = evaluator.at(setting, packings);
    return whole(point) ? point.misfit() : INFINITY;
  };
  if (falling_share(misfit_after, best.misfit())) return point;
  return {};
}

int runs_to_step(const Evaluator& evaluator, int packings) {
  const auto ranged = static_cast<int>(ranged_keys(evaluator).size());
  return evaluator.runs_a_point(packings) * (2 * ranged + most_shares);
}

int runs_to_identify(const Evaluator& evaluator, int packings) {
  const auto ranged = static_cast<int>(ranged_keys(evaluator).size());
  int listed = 0;
  for (const VariedKey& key : evaluator.keys()) listed += std::max(0, static_cast<int>(key.values.size()) - 1);
  return evaluator.runs_a_point(packings) * (listed + 2 * rounds * ranged + 2 * ranged);
}

Identified identify(const Evaluator& evaluator, const Point& best, const Packings& packings) {
  require_values(best, evaluator.targets(), packings.count);
  Identified found;
  const std::vector<std::size_t> ranged = ranged_keys(evaluator);
  for (const std::size_t k : ranged) found.ranged.push_back(evaluator.keys()[k].name);
  add_listed_effects(found, evaluator, best, packings);
  if (ranged.empty()) return found;
  const Vector r = residuals_of(evaluator, best);
  Vector reach = Vector::Constant(std::ssize(ranged), first_probe);
  std::vector<Probe> probes = probes_of(evaluator, best, ranged, reach, packings);
  add_ranged_effects(found, evaluator, best, probes);
  if (r.size() <= std::ssize(ranged)) {
    found.why_not = "there are " + std::to_string(r.size()) + " numbers to compare with and " +
                    std::to_string(ranged.size()) + " keys: an interval needs more numbers than keys";
    return found;
  }
  if (!all_whole(best, probes)) return found.why_not = unsaid_nearby, found;
  Slopes about = slopes_about(evaluator, best, ranged, probes);
  Intervals linear(about);
  for (int k = 1; k < rounds; ++k) {
    reach = linear.half.cwiseMax(least_probe).cwiseMin(first_probe);
    probes = probes_of(evaluator, best, ranged, reach, packings);
    if (!all_whole(best, probes)) return found.why_not = unsaid_nearby, found;
    about = slopes_about(evaluator, best, ranged, probes);
    linear = Intervals(about);
  }
  for (std::size_t i = 0; i < ranged.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (linear.half[k] > 0.5 || bend_over(evaluator, best, probes[i], about, k) <= most_bend) continue;
    found.why_not = "between " + probes[i].low.setting[ranged[i]] + " and " + probes[i].high.setting[ranged[i]] +
                    " of " + evaluator.keys()[ranged[i]].name +
                    " the targets bend or jump: slopes say nothing of an interval";
    return found;
  }
  const bool there = arrived(of_loss(evaluator, about), linear.half);
  for (std::size_t i = 0; i < ranged.size(); ++i)
    found.known.push_back(known_of(evaluator.keys()[ranged[i]], best.setting[ranged[i]],
                                   linear.half[static_cast<Eigen::Index>(i)], there));
  for (Eigen::Index k = 0; k < linear.along.size(); ++k) {
    if (linear.along[k] > 0.5)
      found.flat.push_back(flat_along(evaluator, best, ranged, linear.directions.col(k), packings));
  }
  return found;
}

}  // namespace furrow::validation
