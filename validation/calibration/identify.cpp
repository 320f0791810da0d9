#include "validation/calibration/identify.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "scene/wording.h"

namespace furrow::validation {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr double first_probe = 0.05, least_probe = 0.005;  // of a range, each way
constexpr int rounds = 2;                                  // the second probes about as far as the first interval

std::vector<std::size_t> ranged_keys(const Evaluator& evaluator) {
  std::vector<std::size_t> ranged;
  for (std::size_t k = 0; k < evaluator.keys().size(); ++k) {
    if (!evaluator.keys()[k].listed()) ranged.push_back(k);
  }
  return ranged;
}

// Of all targets, mean over the packings.
Vector residuals_of(const Evaluator& evaluator, const Point& point) {
  std::vector<double> all;
  for (const Json& values : point.values) {
    std::size_t next = 0;
    for (std::size_t k = 0; k < evaluator.targets().all.size(); ++k) {
      for (const double r : residuals(evaluator.targets().all[k], values[k], evaluator.targets().missing)) {
        if (next == all.size()) all.push_back(0);
        all[next++] += r / static_cast<double>(point.values.size());
      }
    }
  }
  return Vector::Map(all.data(), std::ssize(all));
}

// A curve counts once, by whatever number of points.
Vector weights_of(const Evaluator& evaluator) {
  std::vector<double> all;
  for (const CalibrationTarget& target : evaluator.targets().all) {
    const std::size_t points = target.curve ? target.curve->mm.size() : 1;
    all.insert(all.end(), points, target.weight / static_cast<double>(points));
  }
  return Vector::Map(all.data(), std::ssize(all));
}

// One key probed on both sides, at the ends of what its range allows.
struct Probe {
  double below = 0, above = 0;  // shares
  Point low, high;
  double width() const { return above - below; }
};

std::vector<Probe> probes_of(const Evaluator& evaluator, const Point& best, const std::vector<std::size_t>& ranged,
                             const Vector& reach, const Packings& packings) {
  std::vector<Probe> probes(ranged.size());
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < ranged.size(); ++i) {
    const VariedKey& key = evaluator.keys()[ranged[i]];
    const std::string& value = best.setting[ranged[i]];
    const double share = key.share_of(value), off = reach[static_cast<Eigen::Index>(i)];
    const std::string below = key.below(value, off), above = key.above(value, off);
    probes[i].below = key.whole ? key.share_of(below) : std::max(0.0, share - off);
    probes[i].above = key.whole ? key.share_of(above) : std::min(1.0, share + off);
    for (const std::string& at : {below, above}) {
      settings.push_back(best.setting);
      settings.back()[ranged[i]] = at;
    }
  }
  std::vector<Point> points = evaluator.at(settings, packings);
  for (std::size_t i = 0; i < ranged.size(); ++i) {
    probes[i].low = std::move(points[2 * i]);
    probes[i].high = std::move(points[2 * i + 1]);
  }
  return probes;
}

Matrix slopes_of(const Evaluator& evaluator, const std::vector<Probe>& probes, Eigen::Index residuals) {
  Matrix slopes(residuals, std::ssize(probes));
  for (std::size_t i = 0; i < probes.size(); ++i) {
    slopes.col(static_cast<Eigen::Index>(i)) =
        (residuals_of(evaluator, probes[i].high) - residuals_of(evaluator, probes[i].low)) / probes[i].width();
  }
  return slopes;
}

// Where a run says nothing there is no slope.
bool all_whole(const Point& best, const std::vector<Probe>& probes) {
  return whole(best) && std::all_of(probes.begin(), probes.end(),
                                    [](const Probe& probe) { return whole(probe.low) && whole(probe.high); });
}

constexpr const char* unsaid_nearby =
    "at the best setting or close to it a run failed, or does not say every target: there is no slope";

// The linear theory about the best point.
struct Linear {
  Linear(const Vector& r, const Vector& w, const Matrix& slopes) {
    const auto n = static_cast<double>(r.size()), p = static_cast<double>(slopes.cols());
    const double noise = std::max(1.0, n / (n - p) * r.cwiseAbs2().dot(w) / w.sum());
    const Matrix normal = slopes.transpose() * w.asDiagonal() * slopes;
    const Matrix inner = slopes.transpose() * w.cwiseAbs2().asDiagonal() * slopes;
    const double t = quantile(boost::math::students_t(n - p), 0.975);
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(normal);
    directions = eigen.eigenvectors();
    // A direction without any slope is known no better than by its neighbours' rounding.
    const Vector size = eigen.eigenvalues().cwiseMax(1e-12 * std::max(1.0, eigen.eigenvalues().maxCoeff()));
    const Matrix half_inverse = directions * size.cwiseInverse().asDiagonal() * directions.transpose();
    const Matrix covariance = noise * half_inverse * inner * half_inverse;
    const double floor = 1e-9 * noise * inner.trace();
    half = Vector(slopes.cols());
    along = Vector(slopes.cols());
    for (Eigen::Index k = 0; k < slopes.cols(); ++k) {
      const Vector v = directions.col(k);
      along[k] = t * std::sqrt(noise * (v.dot(inner * v) + floor)) / size[k];
      half[k] = t * std::sqrt(std::max(0.0, covariance(k, k)));
    }
    for (Eigen::Index k = 0; k < slopes.cols(); ++k) {
      for (Eigen::Index flat = 0; flat < slopes.cols(); ++flat) {
        if (along[flat] > 0.5) half[k] = std::max(half[k], std::fabs(directions(k, flat)) * along[flat]);
      }
    }
  }
  Matrix directions;
  Vector half, along;  // half the 95 % interval: of each key, along each direction; in shares of the ranges
};

Known known_of(const VariedKey& key, const std::string& value, double half) {
  const double share = key.share_of(value);
  Known known{key.name, value, "", ""};
  known.at_edge = share < 1e-3 || share > 1 - 1e-3;
  if (half > 0.5) return known;
  known.low = key.below(value, half);
  known.high = key.above(value, half);
  if (known.low == known.high) known.low.clear(), known.high.clear();  // no interval has no width
  return known;
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

// Difference of two points in each target, times `scale`.
Effect effect_of(const Evaluator& evaluator, const Point& low, const Point& high, double scale) {
  Effect effect;
  const auto packings = static_cast<double>(low.values.size());
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

std::optional<Point> stepped(const Evaluator& evaluator, const Point& best, const Packings& packings) {
  const std::vector<std::size_t> ranged = ranged_keys(evaluator);
  const Vector r = residuals_of(evaluator, best), w = weights_of(evaluator);
  if (ranged.empty() || r.size() < std::ssize(ranged)) return {};
  const Vector reach = Vector::Constant(std::ssize(ranged), least_probe);
  const std::vector<Probe> probes = probes_of(evaluator, best, ranged, reach, packings);
  if (!all_whole(best, probes)) return {};
  const Matrix slopes = slopes_of(evaluator, probes, r.size());
  const Vector root = w.cwiseSqrt();
  const Vector step = (root.asDiagonal() * slopes).completeOrthogonalDecomposition().solve(root.cwiseProduct(r));
  Setting setting = best.setting;
  for (std::size_t i = 0; i < ranged.size(); ++i) {
    const VariedKey& key = evaluator.keys()[ranged[i]];
    const double share = key.share_of(setting[ranged[i]]) - step[static_cast<Eigen::Index>(i)];
    setting[ranged[i]] = key.at(std::clamp(share, 0.0, 1.0));
  }
  Point point = evaluator.at(setting, packings);
  if (whole(point) && point.misfit() < best.misfit()) return point;
  return {};
}

int runs_to_identify(const Evaluator& evaluator, int packings) {
  const auto ranged = static_cast<int>(ranged_keys(evaluator).size());
  int listed = 0;
  for (const VariedKey& key : evaluator.keys()) listed += std::max(0, static_cast<int>(key.values.size()) - 1);
  return evaluator.runs_a_point(packings) * (listed + 2 * rounds * ranged + 2 * ranged);
}

Identified identify(const Evaluator& evaluator, const Point& best, const Packings& packings) {
  Identified found;
  const std::vector<std::size_t> ranged = ranged_keys(evaluator);
  for (const std::size_t k : ranged) found.ranged.push_back(evaluator.keys()[k].name);
  add_listed_effects(found, evaluator, best, packings);
  if (ranged.empty()) return found;
  const Vector r = residuals_of(evaluator, best), w = weights_of(evaluator);
  Vector reach = Vector::Constant(std::ssize(ranged), first_probe);
  std::vector<Probe> probes = probes_of(evaluator, best, ranged, reach, packings);
  add_ranged_effects(found, evaluator, best, probes);
  if (r.size() <= std::ssize(ranged)) {
    found.why_not = "there are " + std::to_string(r.size()) + " numbers to compare with and " +
                    std::to_string(ranged.size()) + " keys: an interval needs more numbers than keys";
    return found;
  }
  if (!all_whole(best, probes)) return found.why_not = unsaid_nearby, found;
  Linear linear(r, w, slopes_of(evaluator, probes, r.size()));
  for (int k = 1; k < rounds; ++k) {
    reach = linear.half.cwiseMax(least_probe).cwiseMin(first_probe);
    probes = probes_of(evaluator, best, ranged, reach, packings);
    if (!all_whole(best, probes)) return found.why_not = unsaid_nearby, found;
    linear = Linear(r, w, slopes_of(evaluator, probes, r.size()));
  }
  for (std::size_t i = 0; i < ranged.size(); ++i)
    found.known.push_back(
        known_of(evaluator.keys()[ranged[i]], best.setting[ranged[i]], linear.half[static_cast<Eigen::Index>(i)]));
  for (Eigen::Index k = 0; k < linear.along.size(); ++k) {
    if (linear.along[k] > 0.5)
      found.flat.push_back(flat_along(evaluator, best, ranged, linear.directions.col(k), packings));
  }
  return found;
}

}  // namespace furrow::validation
