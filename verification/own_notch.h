// Linear statics of a strip of links with a cut, assembled without the solver.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <vector>

namespace furrow::verification::notched_stem {

inline constexpr double k = 1e4, s = 0.01;  // N/m, m

// Forces in the links of a strip that is pulled by 1 N a column, small displacements; torn: links across y = cut for
// x < to.
struct OwnLink {
  int a, b;
  double force;  // N
};
inline std::vector<OwnLink> own_statics(int rows, int columns, double shear, double cut, double to) {
  std::vector<OwnLink> links;
  const int count = rows * columns;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * count, 2 * count);
  const auto place = [&](int n) { return Eigen::Vector2d(s * (n % columns), s * (n / columns)); };
  std::vector<Eigen::VectorXd> stretch;
  std::vector<double> springs;
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      const Eigen::Vector2d way = place(b) - place(a);
      const double spring = way.norm() < 1.1 * s ? k : way.norm() < 1.5 * s ? shear : 0;
      const double across = place(a).x() + (cut - place(a).y()) * way.x() / (way.y() == 0 ? 1 : way.y());
      const bool torn = place(a).y() < cut && place(b).y() > cut && across < to;
      if (spring == 0 || torn) continue;
      Eigen::VectorXd along = Eigen::VectorXd::Zero(2 * count);
      along.segment<2>(2 * a) = -way.normalized();
      along.segment<2>(2 * b) = way.normalized();
      stiffness += spring * along * along.transpose();
      links.push_back({a, b, 0});
      stretch.push_back(along);
      springs.push_back(spring);
    }
  }
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * count);
  for (int n = count - columns; n < count; ++n) load[2 * n + 1] = 1;
  for (int n = 0; n < 2 * columns; ++n) stiffness.row(n).setZero(), stiffness(n, n) = 1;
  const Eigen::VectorXd u = stiffness.partialPivLu().solve(load);
  for (std::size_t n = 0; n < links.size(); ++n) links[n].force = springs[n] * stretch[n].dot(u);
  return links;
}

}  // namespace furrow::verification::notched_stem
