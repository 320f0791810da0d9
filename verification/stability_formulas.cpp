// A method's own step on a linear system is the one of its published formula.
//
//   [y, memory]_(n+1) = M(h J) [y, memory]_n,   y' = lambda y  and  x'' = -2 zeta omega x' - omega^2 x
//
// Own: M by running the method (studies/amplification.h). Published: M by the formula, its companion form written out
// (studies/published_schemes.cpp, which calls nothing of src/methods): Runge-Kutta polynomials, Adams-Bashforth, Adams
// predictor-corrector pairs as PEC, PECE and P(EC)^2E, Verlet, symplectic Euler and compositions, implicit Euler.
//
// Sources: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, III.1 and III.8; McLachlan 1995 (SIAM
// J. Sci. Comput. 16, 151); Ghrist, Fornberg and Reeger 2012 (BIT 52, 39): the pair AB3-AM3 has no limit on the
// imaginary axis.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "methods/method.h"
#include "verification/check.h"
#include "verification/studies/amplification.h"
#include "verification/studies/published_schemes.h"

namespace furrow::verification {
namespace {

// Directions from the imaginary axis to the negative real one, and damping ratios; within and beyond most regions.
TEST(StabilityFormulas, OwnStepsAreThoseOfThePublishedFormulas) {
  requirement("stability.formula");
  const Tolerance round_off = absolute(1e-12, "round-off of some ten sums of numbers near one; roots apart by 0.01");
  const Tolerance differences = absolute(1e-7, "a Jacobian by differences is right to the root of round-off, 1.5e-8");
  for (const MethodInfo& info : method_catalogue()) {
    const Scheme* scheme = scheme_of(info.name);
    if (!scheme) continue;
    double worst = 0;
    for (const double size : {0.1, 0.37, 1.1}) {
      for (const double part : {0.0, 0.13, 0.4, 0.77, 1.0}) {
        const auto note = [&](double own, double published) { worst = std::max(worst, std::fabs(own - published)); };
        const std::complex<double> z = std::polar(size, std::numbers::pi * (1 + part) / 2);
        if (scheme->by_eigenvalue) note(own_amplification(info.name, z), amplification(*scheme, z));
        const double zeta = info.conservative ? 0 : 2.1 * part;
        note(own_amplification(info.name, zeta, size), amplification(*scheme, zeta, size));
      }
    }
    expect("|M| of the own step, off from the published formula, " + info.name, worst, 0,
           info.dense_jacobian ? differences : round_off);
    expect_true("acts by eigenvalue as published, " + info.name, acts_by_eigenvalue(info.name) == scheme->by_eigenvalue,
                "positions and velocities alike, or not");
  }
}

TEST(StabilityFormulas, AdamsPairOfThirdOrderGrowsOnTheImaginaryAxisFromZeroOn) {
  requirement("stability.formula");
  for (const double angle : {0.05, 0.1, 0.3}) {
    expect_true("odeint_abm3 grows at h lambda = " + std::to_string(angle) + " i",
                own_amplification("odeint_abm3", {0, angle}) > 1 + 1e-12, "published; round-off is below 1e-12");
  }
}

}  // namespace
}  // namespace furrow::verification
