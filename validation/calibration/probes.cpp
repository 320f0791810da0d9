#include "validation/calibration/probes.h"

#include <algorithm>

namespace furrow::validation {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

// A curve counts once, by whatever number of points.
Vector weights_of(const Evaluator& evaluator) {
  std::vector<double> all;
  for (const CalibrationTarget& target : evaluator.targets().all) {
    const std::size_t points = target.curve ? target.curve->mm.size() : 1;
    all.insert(all.end(), points, target.weight / static_cast<double>(points));
  }
  return Vector::Map(all.data(), std::ssize(all));
}

Matrix slopes_of(const Evaluator& evaluator, const std::vector<Probe>& probes, Eigen::Index residuals) {
  Matrix slopes(residuals, std::ssize(probes));
  for (std::size_t i = 0; i < probes.size(); ++i) {
    slopes.col(static_cast<Eigen::Index>(i)) =
        (residuals_of(evaluator, probes[i].high) - residuals_of(evaluator, probes[i].low)) / probes[i].width();
  }
  return slopes;
}

// A bounded loss weighs a target by less the more it misses: d(R^2/(1 + R^2)) = d(R^2)/(1 + R^2)^2.
Vector weights_of_loss(const Evaluator& evaluator, const Vector& r, Vector weights) {
  if (!evaluator.targets().bounded) return weights;
  Eigen::Index next = 0;
  for (const CalibrationTarget& target : evaluator.targets().all) {
    const auto points = target.curve ? std::ssize(target.curve->mm) : 1;
    const double square = r.segment(next, points).squaredNorm() / static_cast<double>(points);
    weights.segment(next, points) /= (1 + square) * (1 + square);
    next += points;
  }
  return weights;
}

// Of an integer half the way to its neighbours; else nothing.
double least_step(const VariedKey& key, const std::string& value) {
  if (!key.whole) return 0;
  const double share = key.share_of(value);
  return 0.5 * std::max(key.share_of(key.above(value, 0)) - share, share - key.share_of(key.below(value, 0)));
}

}  // namespace

std::vector<std::size_t> ranged_keys(const Evaluator& evaluator) {
  std::vector<std::size_t> ranged;
  for (std::size_t k = 0; k < evaluator.keys().size(); ++k) {
    if (!evaluator.keys()[k].listed()) ranged.push_back(k);
  }
  return ranged;
}

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

bool all_whole(const Point& best, const std::vector<Probe>& probes) {
  return whole(best) && std::all_of(probes.begin(), probes.end(),
                                    [](const Probe& probe) { return whole(probe.low) && whole(probe.high); });
}

Slopes slopes_about(const Evaluator& evaluator, const Point& best, const std::vector<std::size_t>& ranged,
                    const std::vector<Probe>& probes) {
  Slopes about{residuals_of(evaluator, best), weights_of(evaluator), {}, Vector(probes.size()), Vector(probes.size())};
  about.slopes = slopes_of(evaluator, probes, about.residuals.size());
  for (std::size_t i = 0; i < ranged.size(); ++i) {
    const VariedKey& key = evaluator.keys()[ranged[i]];
    const std::string& value = best.setting[ranged[i]];
    about.from[static_cast<Eigen::Index>(i)] = key.share_of(value);
    about.least[static_cast<Eigen::Index>(i)] = least_step(key, value);
  }
  return about;
}

Slopes of_loss(const Evaluator& evaluator, Slopes about) {
  about.weights = weights_of_loss(evaluator, about.residuals, about.weights);
  return about;
}

}  // namespace furrow::validation
