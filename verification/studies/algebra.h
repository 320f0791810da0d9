// Eigen's solvers, compiled once for all that uses them here. Dimensions are those of what is handed over.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace furrow::verification {

using Vector = Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

// x with a x = right; a is square and has an inverse.
Vector solved(const Eigen::MatrixXd& a, const Vector& right);
// The same for a symmetric one.
Vector solved(const Sparse& a, const Vector& right);

// Of a symmetric matrix; values ascend, vectors are columns of length 1.
struct Modes {
  Vector values;
  Eigen::MatrixXd vectors;
};
Modes modes_of(const Eigen::MatrixXd& symmetric);

// Eigenvalues of a symmetric matrix that lie below `shift`, counted by Sylvester's law of inertia.
int eigenvalues_below(const Sparse& symmetric, double shift);

// 1/s^2, the square of the lowest angular frequency: of y'' = tangent y, which need not be symmetric, minus the greatest
// real part of an eigenvalue.
double softest_mode(const Eigen::MatrixXd& tangent);

}  // namespace furrow::verification
