// Plane waves, uniform strain and bending of the lattice, by its forces on displaced nodes.
//
//   structural springs ks, diagonal ones kd, skip-one ones kb; spacing s, node mass m; q in radians a spacing
//
//   waves       u_n = A e cos(q.n):  u_n'' = -D(q) u_n
//               D11 = 2/m (ks (1 - cos qx) + kb (1 - cos 2qx) + kd (1 - cos qx cos qy)),  D22 with qx and qy exchanged
//               D12 = 2/m kd sin qx sin qy
//               omega^2 = (D11 + D22)/2 +- sqrt((D11 - D22)^2/4 + D12^2)
//   long waves  C11 = ks + kd + 4 kb  (N/m, two-dimensional)
//               C12 = C66 = kd
//   bending     one row, chords of length s that turn by theta at each node: the skip-one spring gives a moment
//               M = 2 kb s^2 (1 - cos(theta/2)) sin(theta/2) = kb s^2 theta^3/8 + ..., so nothing linear in theta
//
// Source: Born and Huang, Dynamical Theory of Crystal Lattices, sections 24 and 25; bending by geometry.
#include <Eigen/Dense>
#include <numbers>

#include "verification/bare_lattice.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double pi = std::numbers::pi;
constexpr double spacing = 0.1;  // m
constexpr double mass = 3;       // kg
constexpr double ks = 1000;      // N/m
constexpr double kd = 300;       // N/m
constexpr double kb = 170;       // N/m
constexpr int side = 7;          // nodes
constexpr int middle = 3;        // its two neighbours on each side are there

System lattice_system(int rows, int columns, double structural, double shear) {
  Scene scene = bare_lattice(rows, columns, spacing, mass);
  scene.lattice[0].structural.stiffness = structural;
  scene.lattice[0].shear.stiffness = shear;
  scene.lattice[0].bending.stiffness = kb;
  return System(scene);
}

// Force on each node of the lattice for displacements u(row, column).
template <class Displacement>
std::vector<Vector2d> forces(const System& system, const Displacement& u) {
  State y = system.initial_state();
  const NodeArrays& node = system.parts().node;
  for (int n = 0; n < node.count(); ++n) {
    const Vector2d moved = u(node.row[n], node.column[n]);
    y[system.x_of(n)] += moved.x();
    y[system.y_of(n)] += moved.y();
  }
  State rates(y.size());
  system.rhs(0, y, rates);
  std::vector<Vector2d> force;
  for (int n = 0; n < node.count(); ++n)
    force.emplace_back(mass * rates[system.vx_of(n)], mass * rates[system.vy_of(n)]);
  return force;
}

// Half the difference of the forces for u and -u: free of terms of second order.
template <class Displacement>
std::vector<Vector2d> odd_forces(const System& system, const Displacement& u) {
  std::vector<Vector2d> force = forces(system, u);
  const std::vector<Vector2d> back = forces(system, [&](int row, int column) -> Vector2d { return -u(row, column); });
  for (std::size_t n = 0; n < force.size(); ++n) force[n] = 0.5 * (force[n] - back[n]);
  return force;
}

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

TEST(LatticeWaves, UniformStrainLoadsNothingButTheEdge) {
  requirement("lattice.patch");
  const System system = lattice_system(side, side, ks, kd);
  for (const Matrix2d& strain :
       {Matrix2d{{0.1, 0}, {0, 0}}, Matrix2d{{0, 0.1}, {0, 0}}, Matrix2d{{-0.2, 0.1}, {0.3, 0.2}}}) {
    const std::vector<Vector2d> force =
        forces(system, [&](int row, int column) -> Vector2d { return spacing * strain * Vector2d(column, row); });
    double inside = 0;
    for (int row = 2; row < side - 2; ++row)
      for (int column = 2; column < side - 2; ++column) inside = std::max(inside, force[row * side + column].norm());
    expect("force on inner nodes [N]", inside, 0,
           absolute(1e-12, "round-off: twelve links, an ulp of 0.6 m, 1e-16, times up to 1000 N/m"));
  }
}

TEST(LatticeWaves, EdgeForcesAreThoseOfTheElasticConstants) {
  requirement("lattice.elastic_constants");
  constexpr double strain = 1e-5;  // cubic terms 1e-10, round-off 1e-10
  const System system = lattice_system(side, side, ks, kd);
  // Force of the last two columns of the middle row, which carry the stress of one row on the right edge, N/m.
  const auto stress = [&](const Matrix2d& direction) -> Vector2d {
    const std::vector<Vector2d> force = odd_forces(
        system, [&](int row, int column) -> Vector2d { return strain * spacing * direction * Vector2d(column, row); });
    return -(force[middle * side + side - 1] + force[middle * side + side - 2]) / (strain * spacing);
  };
  const char* reason = "cubic terms of a strain of 1e-5, 1e-10, and round-off of 0.6 m against 1e-6 m, 1e-10, times ks";
  expect("C11 [N/m]", stress(Matrix2d{{1, 0}, {0, 0}}).x(), ks + kd + 4 * kb, absolute(2e-7, reason));
  expect("C12 [N/m]", stress(Matrix2d{{0, 0}, {0, 1}}).x(), kd, absolute(2e-7, reason));
  expect("C66 by du/dy [N/m]", stress(Matrix2d{{0, 1}, {0, 0}}).y(), kd, absolute(2e-7, reason));
  expect("C66 by dv/dx [N/m]", stress(Matrix2d{{0, 0}, {1, 0}}).y(), kd, absolute(2e-7, reason));
  expect("shear stress of a rotation [N/m]", stress(Matrix2d{{0, 1}, {-1, 0}}).y(), 0, absolute(2e-7, reason));
}

TEST(LatticeWaves, SkipOneSpringsBendAsTheThirdPowerOfTheAngle) {
  requirement("lattice.bending_moment");
  const System system = lattice_system(1, 3, ks, 0);
  std::vector<double> angles;
  std::vector<double> moments;
  for (const double theta : {0.01, 0.02, 0.04, 0.08, 0.5, 1.5}) {
    // Both arms slope by theta/2; node 2 is s (cos, sin) from the middle one.
    const Vector2d arm(std::cos(theta / 2), std::sin(theta / 2));
    const std::vector<Vector2d> force = forces(system, [&](int /*row*/, int column) -> Vector2d {
      return column == 1 ? Vector2d(0, 0) : spacing * Vector2d((column - 1) * (arm.x() - 1), arm.y());
    });
    const double moment = spacing * (arm.x() * force[2].y() - arm.y() * force[2].x());
    const double exact = -2 * kb * spacing * spacing * (1 - arm.x()) * arm.y();
    expect("moment about the middle node [N m], angle " + std::to_string(theta), moment, exact,
           absolute(2e-15,
                    "round-off: the springs' forces of an ulp of 0.2 m, 3e-17, times 1000 N/m and an arm of 0.1 m, "
                    "across which structural springs act only by rounding"));
    if (theta > 0.1) continue;
    angles.push_back(theta);
    moments.push_back(-moment);
  }
  expect("power of the angle", fitted_slope(angles, moments), 3,
         absolute(8e-4, "next term of the series: d ln M/d ln theta = 3 - theta^2/8 at the greatest angle, 0.08"));
  expect("M / (kb s^2 theta^3), theta -> 0", moments[0] / (kb * spacing * spacing * 1e-6), 1.0 / 8,
         relative(1e-5, "next term of the series, theta^2/16 at 0.01, and round-off, 1e-6"));
}

}  // namespace
}  // namespace furrow::verification
