#include "scene/mechanism.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace furrow {
namespace {

constexpr double zero = 1e-10;  // of the largest eigenvalue: round-off of at most 300 unknowns

class StiffnessMatrix {
 public:
  explicit StiffnessMatrix(const Lattice& l) : lattice_(l) {
    const auto has = [](const std::vector<int>& list, int i) {
      return std::find(list.begin(), list.end(), i) != list.end();
    };
    for (int row = 0; row < l.rows; ++row)
      for (int column = 0; column < l.columns; ++column)
        unknown_.push_back(has(l.fixed_rows, row) || has(l.fixed_columns, column) ? -1 : unknowns_++);
    matrix_ = Eigen::MatrixXd::Zero(2 * unknowns_, 2 * unknowns_);
    add(l.structural.stiffness, {{{0, 1}, {1, 0}}});
    add(l.shear.stiffness, {{{1, 1}, {1, -1}}});
    add(l.bending.stiffness, {{{0, 2}, {2, 0}}});
  }

  int fixed() const { return lattice_.rows * lattice_.columns - unknowns_; }
  const Eigen::MatrixXd& matrix() const { return matrix_; }

 private:
  void add(double stiffness, const std::array<std::array<int, 2>, 2>& steps) {
    for (int row = 0; row < lattice_.rows; ++row)
      for (int column = 0; column < lattice_.columns; ++column)
        for (const auto& [up, right] : steps) add_link(stiffness, row, column, up, right);
  }

  // k e e^T between its two ends, e along the link.
  void add_link(double stiffness, int row, int column, int up, int right) {
    if (row + up >= lattice_.rows || column + right >= lattice_.columns || column + right < 0) return;
    const Eigen::Vector2d e = Eigen::Vector2d(right, up).normalized();
    const Eigen::Matrix2d k = stiffness * e * e.transpose();
    const int a = unknown_[row * lattice_.columns + column];
    const int b = unknown_[(row + up) * lattice_.columns + column + right];
    if (a >= 0) matrix_.block<2, 2>(2 * a, 2 * a) += k;
    if (b >= 0) matrix_.block<2, 2>(2 * b, 2 * b) += k;
    if (a < 0 || b < 0) return;
    matrix_.block<2, 2>(2 * a, 2 * b) -= k;
    matrix_.block<2, 2>(2 * b, 2 * a) -= k;
  }

  const Lattice& lattice_;
  std::vector<int> unknown_;  // of each node; -1: fixed
  int unknowns_ = 0;
  Eigen::MatrixXd matrix_;
};

}  // namespace

int free_motions(const Lattice& lattice) {
  const StiffnessMatrix k(lattice);
  if (k.matrix().size() == 0) return 0;
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k.matrix(), Eigen::EigenvaluesOnly).eigenvalues();
  const double largest = values.maxCoeff();
  if (largest <= 0) return 0;
  const auto none = static_cast<int>((values.array() < zero * largest).count());
  const int as_a_whole = k.fixed() == 0 ? 3 : k.fixed() == 1 ? 1 : 0;
  return std::max(0, none - as_a_whole);
}

}  // namespace furrow
