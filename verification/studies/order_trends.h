// How else methods differ: evaluations a step, the way back, and the energy of an undamped oscillator.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "methods/method.h"
#include "verification/studies/order_observed.h"

namespace furrow::verification {

struct Count {
  double per_step = 0;  // evaluations, once started
  double at_start = 0;  // more than that, in the first steps
};
// On an undamped spring; none for a controlled method.
Count evaluations(const std::string& method);

// Relative change of the energy of x'' = -x in one period, h = angle: from the means over the first and last eighth of
// 64 periods. NaN if it diverges.
double energy_drift(const std::string& method, double angle);

// The h that it takes: a whole number of steps makes a period.
double true_angle(double angle);

// Its leading term, factor * angle^power; nothing if it is not written down for this method.
struct Drift {
  double factor, power;
};
std::optional<Drift> predicted_drift(const std::string& method);

// The same, whole, from the amplification of the method's scheme (published_schemes.h), where one is written down.
std::optional<double> amplified_drift(const std::string& method, double angle);

// The order in which a run through a Hertz impact that is reversed and run back misses its start. With the modified
// equation y' = f + h^p f_p + h^(p+1) f_(p+1) + ... the way back undoes the terms of even power, so p + 1 for even p;
// in P(EC)^2E the term of power 3 is missing too. Where the force starts as t^(3/2), what a step at t loses for good is
// of second order in the force: h^6/t, by the powers of t in force and stiffness, and h^5 ln(T/h) in all. Infinity:
// exact. On a spring, which is in motion when the run starts, a multistep method's first steps add their own error,
// twice: there ab2 is of order 2.
std::optional<double> predicted_return(const MethodInfo& method);

// Whether the way back ends where it began but for round-off.
bool returns_exactly(const std::vector<Point>& points);

}  // namespace furrow::verification
