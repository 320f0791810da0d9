// What published methods make of a linear system y' = J y in one step, from the formula alone (nothing of src/methods is
// called): what a method's own step, which amplification.h runs, is checked against.
//
//   [y, memory]_(n+1) = M(h J) [y, memory]_n,   stable if no eigenvalue of M is larger than one
//
// M is the companion form of the whole scheme as it is run: predictor, corrector, evaluations, what is remembered.
// Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, III.3 and III.8; II, IV.2.
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <functional>
#include <string>
#include <vector>

namespace furrow::verification {

using Matrix = Eigen::MatrixXcd;

// h J as a map; columns are independent vectors. The first `positions` numbers of a vector are positions, followed by
// as many velocities with q' = v, as in OdeSystem.
struct LinearSystem {
  std::function<Matrix(const Matrix&)> rate;  // h J times a matrix
  Eigen::Index size = 0;
  Eigen::Index positions = 0;
};

// One step of a scheme; memory[0] is y, the others are what the scheme remembers (times of h f).
struct Scheme {
  int blocks = 1;  // of memory
  bool by_eigenvalue =
      true;  // each eigenvalue of h J alone decides; false: positions and velocities are treated differently
  std::function<void(const LinearSystem&, std::vector<Matrix>& memory)> step;
  bool conservative = false;  // takes no force that depends on velocity
};

// Null if the method's formula is not written down here, as for a controlled method, which chooses its own step.
const Scheme* scheme_of(const std::string& method);

// Largest modulus of an eigenvalue of M.
double amplification(const Scheme& scheme, const LinearSystem& system);
// For y' = lambda y with z = h lambda.
double amplification(const Scheme& scheme, std::complex<double> z);
// For x'' = -2 zeta omega x' - omega^2 x with angle = h omega.
double amplification(const Scheme& scheme, double zeta, double angle);

}  // namespace furrow::verification
