// Plane waves of the lattice, by its forces on displaced nodes.
//
//   structural springs ks, diagonal ones kd, skip-one ones kb; node mass m; q in radians a spacing
//     u_n = A e cos(q.n):  u_n'' = -D(q) u_n
//     D11 = 2/m (ks (1 - cos qx) + kb (1 - cos 2qx) + kd (1 - cos qx cos qy)),  D22 with qx and qy exchanged
//     D12 = 2/m kd sin qx sin qy
//     omega^2 = (D11 + D22)/2 +- sqrt((D11 - D22)^2/4 + D12^2)
//
// Source: Born and Huang, Dynamical Theory of Crystal Lattices, sections 24 and 25.
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/displaced_lattice.h"

namespace furrow::verification::lattice_waves {
namespace {

Matrix2d dynamical_matrix(double qx, double qy) {
  const auto own = [](double a, double b) {
    return ks * (1 - std::cos(a)) + kb * (1 - std::cos(2 * a)) + kd * (1 - std::cos(a) * std::cos(b));
  };
  const double d12 = kd * std::sin(qx) * std::sin(qy);
  return 2 / mass * Matrix2d{{own(qx, qy), d12}, {d12, own(qy, qx)}};
}

// The same from the definition: sum over all neighbours of k/m d d^T/|d|^2 (1 - cos q.d).
Matrix2d neighbour_sum(double qx, double qy) {
  Matrix2d sum = Matrix2d::Zero();
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      const int square = i * i + j * j;
      const double k = square == 1 ? ks : square == 2 ? kd : square == 4 ? kb : 0;
      if (k > 0)
        sum += k / mass * Vector2d(i, j) * Vector2d(i, j).transpose() / square * (1 - std::cos(i * qx + j * qy));
    }
  }
  return sum;
}

// Sixteen wave vectors over the zone, none on a line of symmetry but the first four.
std::pair<double, double> wave_vector(int k) { return {pi * (k % 4 + 1) / 4, pi * (k < 4 ? 0 : (2.0 * k - 5) / 28)}; }

TEST(LatticeWaves, DynamicalMatrixIsTheSumOverNeighbours) {
  requirement("lattice.dispersion");
  double worst = 0;
  for (int k = 0; k < 16; ++k) {
    const auto [qx, qy] = wave_vector(k);
    worst = std::max(worst, (dynamical_matrix(qx, qy) - neighbour_sum(qx, qy)).cwiseAbs().maxCoeff());
  }
  expect("D(q), closed form against sum, 16 wave vectors [1/s^2]", worst, 0,
         absolute(2e-12, "round-off of twelve terms of up to 1e3 1/s^2"));
}

TEST(LatticeWaves, BothBranchesHaveTheirFrequencies) {
  requirement("lattice.dispersion");
  constexpr double amplitude = 3e-6;  // of the spacing: cubic terms 1e-11, round-off 1e-10
  const System system = lattice_system(side, side, ks, kd);
  for (int k = 0; k < 16; ++k) {
    const auto [qx, qy] = wave_vector(k);
    const Matrix2d d = dynamical_matrix(qx, qy);
    const double mean = 0.5 * d.trace();
    const double split = std::sqrt(0.25 * (d(0, 0) - d(1, 1)) * (d(0, 0) - d(1, 1)) + d(0, 1) * d(0, 1));
    for (const double omega2 : {mean - split, mean + split}) {
      Vector2d e(d(0, 1), omega2 - d(0, 0));
      if (e.norm() < 1e-9 * mean) e = {omega2 - d(1, 1), d(0, 1)};
      e.normalize();
      const auto wave = [&, qx = qx, qy = qy](int row, int column) -> Vector2d {
        return amplitude * spacing * e * std::cos(qx * (column - middle) + qy * (row - middle));
      };
      const Vector2d a = odd_forces(system, wave)[middle * side + middle] / (mass * amplitude * spacing);
      const std::string name = ", q = (" + std::to_string(qx) + ", " + std::to_string(qy) + "), " +
                               (omega2 < mean ? "lower" : "upper") + " branch";
      const char* reason =
          "round-off: four half ulps of 0.6 m, 6e-17 each, times 2 (ks + kd + kb)/m, against an amplitude of 3e-7 m";
      expect("omega^2 [1/s^2]" + name, -a.dot(e), omega2, absolute(7e-7, reason));
      expect("acceleration across the polarisation [1/s^2]" + name, a.x() * e.y() - a.y() * e.x(), 0,
             absolute(7e-7, reason));
    }
  }
}

}  // namespace
}  // namespace furrow::verification::lattice_waves
