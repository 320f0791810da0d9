// The largest stable step of a method on a damped oscillator, found by running the method itself.
#pragma once

#include <string>

namespace furrow {

// x'' = -2 zeta omega x' - omega^2 x.
struct Oscillator {
  double omega = 1;  // rad/s
  double zeta = 0;   // -, damping ratio
};

// s: the step above which the method's solution grows; infinity for a controlled method, which chooses its own, for an
// implicit one that grows at no step, and for an oscillator that does not move. Within 0.1 %; a growth of less than
// 1e-5 a step is not seen (Adams-Bashforth 2 on an undamped oscillator grows at any step, by (h omega)^4 / 4).
double largest_stable_step(const std::string& method, const Oscillator& oscillator);

}  // namespace furrow
