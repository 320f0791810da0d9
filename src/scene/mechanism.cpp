#include "scene/mechanism.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scene/lattice_parts.h"

namespace furrow {
namespace {

constexpr double zero = 1e-10;  // of the largest eigenvalue: round-off of at most 300 unknowns

// One unknown for each coordinate of a node that is not held.
class StiffnessMatrix {
 public:
  explicit StiffnessMatrix(const Lattice& l) : lattice_(l), held_(held_nodes(l)) {
    for (const Held& node : held_)
      for (const bool held : {node.x, node.y}) unknown_.push_back(held ? -1 : unknowns_++);
    matrix_ = Eigen::MatrixXd::Zero(unknowns_, unknowns_);
    for (const LatticeLink& link : links_of(l))
      if (!link.torn) add(link);
  }

  const Eigen::MatrixXd& matrix() const { return matrix_; }

  // Motions of the lattice as a whole that what is held allows: 3 less the rank of what they do to it.
  int as_a_whole() const {
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(2 * std::ssize(held_), 3);
    for (int n = 0; n < std::ssize(held_); ++n) {
      const int row = n / lattice_.columns, column = n % lattice_.columns;
      if (held_[n].x) moved.row(2 * n) << 1, 0, -row;
      if (held_[n].y) moved.row(2 * n + 1) << 0, 1, column;
    }
    return 3 - static_cast<int>(Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(moved).rank());
  }

 private:
  // k e e^T between its two ends, e along the link.
  void add(const LatticeLink& link) {
    const int columns = lattice_.columns;
    const Eigen::Vector2d e =
        Eigen::Vector2d(link.b % columns - link.a % columns, link.b / columns - link.a / columns).normalized();
    const std::array<int, 4> at{unknown_[2 * link.a], unknown_[2 * link.a + 1], unknown_[2 * link.b],
                                unknown_[2 * link.b + 1]};
    const std::array<double, 4> stretch{-e.x(), -e.y(), e.x(), e.y()};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        if (at[i] >= 0 && at[j] >= 0) matrix_(at[i], at[j]) += link.stiffness * stretch[i] * stretch[j];
  }

  const Lattice& lattice_;
  std::vector<Held> held_;
  std::vector<int> unknown_;  // of each coordinate of each node; -1: held
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
  return std::max(0, none - k.as_a_whole());
}

}  // namespace furrow
