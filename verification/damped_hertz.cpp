// The exact solution of a damped impact, on which other pages build, against two unrelated computations.
//
//   overlap and speed at the turn: the equation of motion itself by graded Runge-Kutta steps in long double
//   contact time: int p^(-1/5) ds by Simpson's rule, the tanh-sinh rule being the one that the pages use
//
// Source and equations: damped_hertz.h.
#include "verification/damped_hertz.h"

#include "verification/check.h"

namespace furrow::verification {
namespace {

// Contact time once more: w^5 in place of s takes the singular ends away, and Simpson's rule does the rest.
long double contact_time_by_simpson(const DampedHertz& exact) {
  constexpr int n = 8000;
  const long double half = exact.release() / 2;
  long double sum = 0;
  for (int k = 1; k <= n; ++k) {
    const long double w = static_cast<long double>(k) / n;
    const long double s = half * w * w * w * w * w;
    const long double both = std::pow(exact.p(s), -0.2L) + std::pow(exact.p_before_release(s), -0.2L);
    sum += (k == n ? 1 : k % 2 == 1 ? 4 : 2) * both * 5 * half * w * w * w * w;
  }
  return sum / (3 * n);
}

TEST(DampedHertz, ExactSolutionAgreesWithAnIntegrationOfTheEquation) {
  requirement("normal.damped");
  const auto truncation = absolute(2e-14, "truncation of 8000 graded steps of order 4, and round-off of pow");
  for (const double beta : {0.01, 0.2, 0.6, 1.0, 2.0, 20.0}) {
    const std::string what = "beta " + std::to_string(beta);
    const DampedHertz exact(beta);
    const auto turn = exact.turning();
    const Motion deepest = integrate_impact(beta, exact.time(turn), 8000);
    expect(what + ": greatest overlap over L", static_cast<double>(deepest.overlap),
           static_cast<double>(exact.overlap(turn)), truncation);
    expect(what + ": speed there over v", static_cast<double>(deepest.speed), 0, truncation);
    if (beta >= 1) continue;
    expect(what + ": contact time by Simpson's rule", static_cast<double>(contact_time_by_simpson(exact)),
           static_cast<double>(exact.contact_time()),
           relative(1e-14, "Simpson's h^4 at 8000 points, 2e-15, and round-off"));
  }
}

}  // namespace
}  // namespace furrow::verification
