// What a method makes of a linear system y' = J y in one step: its amplification, from the formula of the method alone
// (nothing of src/methods is called), and the steps at which it grows.
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
  std::string family{};       // equal for methods that are the same scheme
};

// Null if the method's theory is not written down here, as for a controlled method, which chooses its own step.
const Scheme* scheme_of(const std::string& method);

// Largest modulus of an eigenvalue of M.
double amplification(const Scheme& scheme, const LinearSystem& system);
// For y' = lambda y with z = h lambda.
double amplification(const Scheme& scheme, std::complex<double> z);

// A solution counts as growing if it gains more than this a step, beyond what the exact one does. A run of some
// thousand steps sees it; a method that grows at any step, like AB2 on an undamped spring, gets the step from which
// that matters.
inline constexpr double growth_seen = 1e-5;

// Largest h omega at which x'' = -2 zeta omega x' - omega^2 x does not grow, coming from zero; `most` if there is none
// below.
double largest_stable_angle(const Scheme& scheme, double zeta, double most = 100);

// The same for y' = lambda y: largest h |lambda| along the direction of lambda.
double largest_stable_radius(const Scheme& scheme, std::complex<double> direction, double growth = growth_seen,
                             double most = 100);

}  // namespace furrow::verification
