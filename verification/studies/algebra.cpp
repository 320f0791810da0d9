#include "verification/studies/algebra.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>

namespace furrow::verification {

Vector solved(const Eigen::MatrixXd& a, const Vector& right) { return a.partialPivLu().solve(right); }

Vector solved(const Sparse& a, const Vector& right) { return Eigen::SimplicialLDLT<Sparse>(a).solve(right); }

Modes modes_of(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

int eigenvalues_below(const Sparse& symmetric, double shift) {
  Sparse shifted = symmetric;
  for (Eigen::Index i = 0; i < shifted.rows(); ++i) shifted.coeffRef(i, i) -= shift;
  const Vector pivots = Eigen::SimplicialLDLT<Sparse>(shifted).vectorD();
  return static_cast<int>((pivots.array() < 0).count());
}

double softest_mode(const Eigen::MatrixXd& tangent) {
  return -Eigen::EigenSolver<Eigen::MatrixXd>(tangent, false).eigenvalues().real().maxCoeff();
}

}  // namespace furrow::verification
