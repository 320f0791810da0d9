// Where the methods fail: the step at which the solver blows up against the method's amplification factor.
//
//   x'' = -2 zeta omega x' - omega^2 x
//   [x, x', memory]_(n+1) = M(omega h, zeta) [x, x', memory]_n
//   stable if no eigenvalue of M is larger than one
//
// M is found by running the method's own step (studies/amplification.h), whoever wrote the method; see
// stability_formulas.cpp for those whose formula is published.
//
// Limits in the literature: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations II, IV.2 and V.1.
#include <cmath>
#include <string>

#include "methods/method.h"
#include "verification/check.h"
#include "verification/studies/amplification.h"
#include "verification/studies/blow_up.h"

namespace furrow::verification {
namespace {

constexpr double any = -1;  // instead of a limit: not asked

struct Known {
  const char* method;
  double real, imaginary;  // h |lambda|
};
// Roots of the methods' characteristic polynomials, by hand or from the source above.
const Known known[] = {
    {"pece", 2, 1.287},
    {"pec", 0.5, 2.0 / 3},
    {"pecece", 1.478, 1.691},
    {"ab2", 1, any},
    {"rk4", 2.785, std::sqrt(8.0)},
    {"verlet", any, 2},
    {"symplectic_euler", any, 2},
    {"odeint_ab3", 6.0 / 11, 0.7237},
    {"odeint_ab4", 0.3, 0.430},
    {"odeint_ab5", 90.0 / 551, any},
    {"odeint_abm3", 1.73, any},
    {"odeint_abm4", 1.284, any},
    {"odeint_abm5", 0.946, any},
};

TEST(StabilityLimits, AmplificationFactorsHaveTheKnownLimits) {
  requirement("stability.limits");
  const auto rounded = relative(2e-3, "the known limits are given to three digits");
  for (const Known& k : known) {
    const std::string name = k.method;
    if (k.real != any) expect(name + ": h |lambda| on the real axis", largest_stable_radius(name, -1), k.real, rounded);
    if (k.imaginary != any) expect(name + ": omega h, undamped", largest_stable_angle(name, 0), k.imaginary, rounded);
  }
  expect("odeint_abm5: omega h, undamped", largest_stable_angle("odeint_abm5", 0), 0.32,
         absolute(0.005, "the known limit is given to two digits"));
  // |r|^2 = 1 + theta^4/2 + ... for AB2: a growth of g a step is reached at theta = (4 g)^(1/4).
  expect("ab2: omega h at which an undamped spring grows by 1e-5 a step", largest_stable_angle("ab2", 0),
         std::pow(4 * growth_seen, 0.25), relative(0.01, "the next term of the growth, of relative size theta^2"));
  for (const double zeta : {0.1, 1.0, 5.0}) {
    expect("symplectic_euler: omega h, damping ratio " + std::to_string(zeta),
           largest_stable_angle("symplectic_euler", zeta), 2 * (std::sqrt(1 + zeta * zeta) - zeta),
           relative(1e-4, "closed form; the growth that passes moves the limit by 1e-5 or so"));
  }
}

TEST(StabilityLimits, PaperMethodOnADampedSpring) {
  requirement("stability.limits");
  const struct {
    double zeta, limit;
  } table[] = {{0, 1.287}, {0.01, 1.295}, {0.1, 1.344}, {0.5, 1.439}, {1, 2.0}, {5, 0.202}};
  for (const auto& [zeta, limit] : table) {
    const std::string at = ", damping ratio " + std::to_string(zeta);
    const double theory = largest_stable_angle("pece", zeta);
    expect("omega h by the roots of r^2 = r (1 + z + 3/4 z^2) - z^2/4" + at, theory, limit,
           relative(1e-3, "the limits are given to four digits"));
  }
}

// Not only where each method is well known: both kinds of force, all damping ratios, every method with a theory.
TEST(StabilityLimits, SolverBlowsUpWhereTheAmplificationFactorSays) {
  requirement("stability.limits");
  const char* const why = "growth of 1 % is seen in a thousand steps";
  for (const MethodInfo& method : method_catalogue()) {
    for (const double zeta : {0.0, 0.01, 0.1, 0.5, 1.0, 5.0}) {
      if (method.controlled || (zeta > 0 && method.conservative)) continue;
      const double limit = largest_stable_angle(method.name, zeta);
      const std::string at = method.name + ", damping ratio " + std::to_string(zeta) +
                             ": holds at 0.99 of omega h = " + std::to_string(limit) + " and blows up at 1.01: ";
      const auto holds_up_to_it = [&](const Oscillation& o) {
        return !grows(method.name, o, 0.99 * limit) && (limit >= largest_angle || grows(method.name, o, 1.01 * limit));
      };
      expect_true(at + "a node on a link", holds_up_to_it(spring_oscillation(zeta)), why);
      expect_true(at + "a disc on a wall", holds_up_to_it(contact_oscillation(zeta)), why);
    }
  }
}

}  // namespace
}  // namespace furrow::verification
