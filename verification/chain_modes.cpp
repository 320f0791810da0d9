// Longitudinal waves of a chain with fixed and with free ends, in the time domain.
//
//   m u_n'' = k (u_(n+1) - 2 u_n + u_(n-1)),  and the same with dampers c on u'
//   fixed ends, N free masses:  u_n = sin(j pi n/(N+1)),      w_j = 2 sqrt(k/m) sin(j pi/(2 (N+1))),  n, j = 1 ... N
//   free ends, N masses:        u_n = cos(j pi (n + 1/2)/N),  w_j = 2 sqrt(k/m) sin(j pi/(2 N)),      n, j = 0 ... N-1
//   let go at rest:
//     u(t) = u(0) e^(-z w t) (cos wd t + z w/wd sin wd t),  z = c w_j/(2 k),  wd = w sqrt(1 - z^2)
//
// Along its line the chain is linear at any amplitude, so that nothing but the method and round-off is left.
// Source: Brillouin, Wave Propagation in Periodic Structures, chapters 1 to 3.
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/chain.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification::chain_modes {
namespace {

struct Ends {
  bool fixed;
  double shape(int j, int n) const {
    return fixed ? std::sin(j * pi * (n + 1) / (masses + 1)) : std::cos(j * pi * (n + 0.5) / masses);
  }
  double omega(int j) const {
    return 2 * std::sqrt(stiffness / mass) * std::sin(j * pi / (2 * (fixed ? masses + 1 : masses)));
  }
};

// Lets the chain go in mode j, runs it for one and a quarter periods, and expects it in that mode and no other.
void expect_pure_mode(Ends ends, int j, double damping) {
  const double omega = ends.omega(j);
  const double zeta = damping * omega / (2 * stiffness);
  const double wd = omega * std::sqrt(1 - zeta * zeta);
  const double end = 2.5 * pi / omega;
  const double want = std::exp(-zeta * omega * end) * (std::cos(wd * end) + zeta * omega / wd * std::sin(wd * end));

  const int first = ends.fixed ? 1 : 0;  // column of the first free mass
  Scene scene = chain_scene(masses + 2 * first);
  if (ends.fixed) scene.lattice[0].fixed_columns = {0, masses + 1};
  scene.lattice[0].structural.damping = damping;
  for (int n = 0; n < masses; ++n)
    scene.lattice[0].node.push_back({.column = n + first, .displacement = {amplitude * ends.shape(j, n), 0}});
  const Ran ran = run_scene(scene, "rk4", step_in_rad / omega, end);

  double in_mode = 0;
  double leak = 0;
  for (int other = ends.fixed ? 1 : 0; other < masses + first; ++other) {
    double projection = 0;
    double norm = 0;
    for (int n = 0; n < masses; ++n) {
      const double u = ran.y[ran.system.x_of(n)] - (n + first) * spacing;
      projection += u / amplitude * ends.shape(other, n);
      norm += ends.shape(other, n) * ends.shape(other, n);
    }
    (other == j ? in_mode : leak) = other == j ? projection / norm : std::max(leak, std::fabs(projection / norm));
  }
  const std::string name = std::string(ends.fixed ? "fixed" : "free") + " ends, c = " + std::to_string(int(damping)) +
                           " N s/m, mode " + std::to_string(j);
  constexpr double truncation = step_in_rad * step_in_rad * step_in_rad * step_in_rad / 120 * 2.5 * pi;
  expect("amplitude after 5/4 periods, " + name, in_mode, want,
         absolute(2 * truncation, "truncation of rk4: (omega h)^4/120 a radian over 5/4 periods, doubled"));
  expect(
      "amplitude of all other modes, " + name, leak, 0,
      absolute(8e-14, "round-off: half an ulp of 0.9 m against 20 mm, 3e-15, a step, as a random walk of 785 steps"));
}

TEST(ChainModes, StaysInItsModeBetweenFixedEnds) {
  requirement("lattice.chain_modes");
  for (int j = 1; j <= masses; ++j) expect_pure_mode({.fixed = true}, j, 0);
}

TEST(ChainModes, StaysInItsModeWithFreeEnds) {
  requirement("lattice.chain_modes");
  for (int j = 1; j < masses; ++j) expect_pure_mode({.fixed = false}, j, 0);
}

TEST(ChainModes, DampersOnTheLinksDampEachModeByItsOwnRatio) {
  requirement("lattice.chain_damping");
  for (int j = 1; j <= masses; ++j) expect_pure_mode({.fixed = true}, j, 4);
}

}  // namespace
}  // namespace furrow::verification::chain_modes
