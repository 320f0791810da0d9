// Stress of a disc from the forces at its contacts.
//
//   sigma     = (1/V) sum over contacts of b (x) F, symmetric part
//   von Mises = sqrt(sxx^2 - sxx syy + syy^2 + 3 sxy^2), of plane stress: szz = 0
//
// b points from the centre to the contact point, F acts on the disc, V is its volume. Tension is positive.
// Source: Rojek, Karlis, Malinowski and Beer 2013, as the paper (README.md) cites it.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace furrow {

using Stress = Eigen::Matrix2d;  // Pa

// What one contact adds to V sigma (N m).
inline Stress stress_moment(const Eigen::Vector2d& branch, const Eigen::Vector2d& force) {
  const Stress outer = branch * force.transpose();
  return 0.5 * (outer + outer.transpose());
}

inline double von_mises(const Stress& s) {
  return std::sqrt(s(0, 0) * s(0, 0) - s(0, 0) * s(1, 1) + s(1, 1) * s(1, 1) + 3 * s(0, 1) * s(0, 1));
}

}  // namespace furrow
