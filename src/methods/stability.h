// The largest stable step of a method on a damped oscillator, by the eigenvalues of its step, which is linear there and
// is found by running the method itself.
#pragma once

#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "system/ode.h"

namespace furrow {

// Of one step of h on a linear system y' = J y, taken as a map of y and all states that the method remembers. It is
// found by running the method itself, once its opening steps are made.
std::vector<std::complex<double>> step_eigenvalues(const std::string& method, const OdeSystem& linear, double h);

// x'' = -2 zeta omega x' - omega^2 x.
struct Oscillator {
  double omega = 1;  // rad/s
  double zeta = 0;   // -, damping ratio
};

// 1/s, magnitude of the larger eigenvalue.
inline double fastest_rate(const Oscillator& o) {
  return o.omega * (o.zeta > 1 ? o.zeta + std::sqrt(o.zeta * o.zeta - 1) : 1);
}

// -, growth of a solution in a step: less is not visible in a run of ten thousand steps.
inline constexpr double growth_seen = 1e-5;

// s: the shortest step at which the method's solution grows, even if it does not at a longer one; infinity for a
// controlled method, which chooses its own, for an implicit one that grows at no step, and for an oscillator that does
// not move; 0 if it grows at the shortest step tried, a thousandth of 1/omega (damped: of the time of the fastest
// decay) or if the oscillator is not finite. Within 0.1 %; a growth of less than growth_seen a step is not counted
// (Adams-Bashforth 2 on an undamped oscillator grows at any step, by (h omega)^4 / 4; 1e-5 is reached at h omega =
// 0.08).
double largest_stable_step(const std::string& method, const Oscillator& oscillator);

}  // namespace furrow
