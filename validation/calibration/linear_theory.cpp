#include "validation/calibration/linear_theory.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

namespace furrow::validation {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

// By the keys that are free, the others where they are; of several that are as good, the shortest step.
Vector step_of(const std::vector<Eigen::Index>& free, const Slopes& about, const Vector& residuals) {
  const Vector root = about.weights.cwiseSqrt();
  const Matrix weighted = root.asDiagonal() * about.slopes(Eigen::all, free);
  return -weighted.completeOrthogonalDecomposition().solve(root.cwiseProduct(residuals));
}

// The place among the free keys of the one that the step takes out of its range first; if there is none, of one that it
// moves by less than the least.
std::optional<std::size_t> key_to_settle(const std::vector<Eigen::Index>& free, const Slopes& about,
                                         const Vector& wanted) {
  std::optional<std::size_t> settled;
  double nearest = 1;  // share of the step up to the end of a range
  for (std::size_t i = 0; i < free.size(); ++i) {
    const double step = wanted[static_cast<Eigen::Index>(i)], from = about.from[free[i]];
    const double share = step == 0 ? 1 : (step > 0 ? 1 - from : -from) / step;
    if (share < nearest) nearest = share, settled = i;
  }
  for (std::size_t i = 0; i < free.size() && !settled; ++i) {
    if (std::fabs(wanted[static_cast<Eigen::Index>(i)]) < about.least[free[i]]) settled = i;
  }
  return settled;
}

}  // namespace

Intervals::Intervals(const Slopes& about) {
  const Vector &r = about.residuals, &w = about.weights;
  const Matrix& slopes = about.slopes;
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

Vector step_within_ranges(const Slopes& about) {
  Vector step = Vector::Zero(about.from.size());
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < about.from.size(); ++k) free.push_back(k);
  while (!free.empty()) {
    const Vector wanted = step_of(free, about, about.residuals + about.slopes * step);
    const std::optional<std::size_t> settled = key_to_settle(free, about, wanted);
    if (!settled) {
      step(free) = wanted;
      break;
    }
    const Eigen::Index k = free[*settled];
    const double to = about.from[k] + wanted[static_cast<Eigen::Index>(*settled)];
    step[k] = to < 0 || to > 1 ? std::clamp(to, 0.0, 1.0) - about.from[k] : 0;
    free.erase(free.begin() + static_cast<std::ptrdiff_t>(*settled));
  }
  return step;
}

bool arrived(const Slopes& about, const Vector& half) {
  return (step_within_ranges(about).array().abs() <= half.array()).all();
}

double bend(const Vector& low, const Vector& middle, const Vector& high, double at, const Vector& weights) {
  const Vector root = weights.cwiseSqrt();
  const double off = root.cwiseProduct(middle - low - at * (high - low)).norm();
  return off > 0 ? 2 * off / root.cwiseProduct(high - low).norm() : 0;
}

std::optional<double> falling_share(const std::function<double(double)>& misfit_after, double before) {
  double share = 1;
  for (int k = 0; k < most_shares; ++k, share /= 2) {
    if (misfit_after(share) < before) return share;
  }
  return {};
}

}  // namespace furrow::validation
