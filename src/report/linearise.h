// A scene linearised about a state:  e' = J e  for a small change e of the numbers that affect the motion.
#pragma once

#include <Eigen/Sparse>
#include <complex>
#include <string>
#include <vector>

#include "run/system.h"

namespace furrow {

struct Linearised {
  std::vector<int> acting;            // places in the state: positions, velocities, spins, springs in use
  Eigen::Index positions = 0;         // of them, at the front; as many velocities follow
  Eigen::SparseMatrix<double> rates;  // 1/s and mixed units, J by central differences of rhs at a fixed time
};

// Where rhs has a kink within the differences' width (a contact that just slips or just lets go) J is the mean of both
// sides.
Linearised linearise(const System& system, double t, const State& y);

// 1/s: all eigenvalues of J if it has at most `dense` rows, else those of its restriction to a Krylov space of `dense`
// dimensions (Arnoldi), which are right at the rim of the spectrum, where the limits of explicit methods are decided.
// Source: Saad, Numerical Methods for Large Eigenvalue Problems, chapter 6.
Eigen::VectorXcd spectrum(const Linearised& linearised, Eigen::Index dense = 300);

// The eigenvector whose eigenvalue is nearest to `value`, by inverse iteration.
Eigen::VectorXcd eigenvector(const Linearised& linearised, std::complex<double> value);

// Which contact or link has the largest part in a motion: viscous power and elastic power, |dF . dv|, summed over
// normal, shear and rolling. Empty if nothing acts.
struct Driver {
  std::string name;
  double share = 0;  // of the power of all contacts and links
  std::string how;   // "normal", "shear", "rolling" or "link": its largest contribution
};
Driver driver_of(const System& system, double t, const State& y, const Linearised& linearised,
                 const Eigen::VectorXcd& motion, std::complex<double> value);

}  // namespace furrow
