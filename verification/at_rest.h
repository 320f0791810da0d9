// Where a scene rests at one moment: Newton's method on the accelerations that the solver gives, differenced.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "run/system.h"
#include "verification/studies/algebra.h"

namespace furrow::verification {

// m/s^2, of all bodies: x in turn, then y.
inline Eigen::VectorXd accelerations(const System& system, double t, const State& y) {
  State rates(y.size());
  system.rhs(t, y, rates);
  const auto n = static_cast<std::ptrdiff_t>(system.positions());
  return Eigen::Map<const Eigen::VectorXd>(rates.data() + n, n);
}

// 1/s^2: how the accelerations follow the places, by central differences. A coordinate that is held follows only itself.
inline Eigen::MatrixXd tangent(const System& system, double t, const State& y, double difference) {
  const auto n = static_cast<Eigen::Index>(system.positions());
  Eigen::MatrixXd j(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    State ahead = y, behind = y;
    ahead[k] += difference;
    behind[k] -= difference;
    j.col(k) = (accelerations(system, t, ahead) - accelerations(system, t, behind)) / (ahead[k] - behind[k]);
  }
  for (Eigen::Index k = 0; k < n; ++k)
    if (j.row(k).isZero(0)) j(k, k) = -1;
  return j;
}

// The state at rest near y; with a few steps less, where it does not get nearer.
inline State at_rest(const System& system, double t, State y, double difference) {
  for (int step = 0; step < 12; ++step) {
    const Eigen::VectorXd a = accelerations(system, t, y);
    const Eigen::VectorXd by = solved(tangent(system, t, y, difference), a);
    for (Eigen::Index k = 0; k < by.size(); ++k) y[k] -= by[k];
    if (by.norm() < 1e-13 * difference / 1e-6) break;
  }
  return y;
}

}  // namespace furrow::verification
