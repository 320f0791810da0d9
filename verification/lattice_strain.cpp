// Uniform strain and bending of the lattice, by its forces on displaced nodes.
//
//   structural springs ks, diagonal ones kd, skip-one ones kb; spacing s
//   strain (the limit of long waves):
//     C11 = ks + kd + 4 kb  (N/m, two-dimensional)
//     C12 = C66 = kd
//   bending of one row, chords of length s that turn by theta at each node: the skip-one spring gives a moment
//     M = 2 kb s^2 (1 - cos(theta/2)) sin(theta/2) = kb s^2 theta^3/8 + ..., so nothing linear in theta
//
// Source: Born and Huang, Dynamical Theory of Crystal Lattices, sections 24 and 25; bending by geometry.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verification/check.h"
#include "verification/displaced_lattice.h"
#include "verification/running.h"

namespace furrow::verification::lattice_waves {
namespace {

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
}  // namespace furrow::verification::lattice_waves
