// Longitudinal waves of a chain: fixed and free ends in the time domain, and dispersion with skip-one springs.
//
//   m u_n'' = k (u_(n+1) - 2 u_n + u_(n-1)) + kb (u_(n+2) - 2 u_n + u_(n-2)),  and the same with dampers c, cb on u'
//   fixed ends, N free masses:  u_n = sin(j pi n/(N+1)),      w_j = 2 sqrt(k/m) sin(j pi/(2 (N+1))),  n, j = 1 ... N
//   free ends, N masses:        u_n = cos(j pi (n + 1/2)/N),  w_j = 2 sqrt(k/m) sin(j pi/(2 N)),      n, j = 0 ... N-1
//   let go at rest:  u(t) = u(0) e^(-z w t) (cos wd t + z w/wd sin wd t),  z = c w_j/(2 k),  wd = w sqrt(1 - z^2)
//   plane wave:  w^2 = 4 k/m sin^2(q/2) + 4 kb/m sin^2(q)
//
// Along its line the chain is linear at any amplitude, so that nothing but the method and round-off is left.
// Source: Brillouin, Wave Propagation in Periodic Structures, chapters 1 to 3.
#include <numbers>

#include "verification/bare_lattice.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double spacing = 0.1;       // m
constexpr double mass = 2;            // kg
constexpr double stiffness = 800;     // N/m
constexpr double skip = 300;          // N/m, skip-one springs
constexpr double amplitude = 0.02;    // m
constexpr int masses = 8;             // free ones
constexpr double step_in_rad = 0.01;  // omega h

Scene chain_scene(int columns) {
  Scene scene = bare_lattice(1, columns, spacing, mass);
  scene.lattice[0].structural.stiffness = stiffness;
  return scene;
}

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

TEST(ChainModes, SkipOneSpringsAddTheirTermToTheDispersion) {
  requirement("lattice.chain_dispersion");
  constexpr int columns = 9;
  constexpr int middle = 4;  // both of its neighbours on each side are there
  Scene scene = chain_scene(columns);
  scene.lattice[0].bending = {.stiffness = skip, .damping = 30};
  scene.lattice[0].structural.damping = 50;
  const System system(scene);
  for (int k = 1; k <= 16; ++k) {
    const double q = k * pi / 16;
    State y = system.initial_state();
    State moving = y;
    for (int n = 0; n < columns; ++n) {
      y[system.x_of(n)] += amplitude * std::cos(q * (n - middle));
      moving[system.vx_of(n)] = amplitude * std::cos(q * (n - middle));
    }
    State rates(y.size());
    system.rhs(0, y, rates);
    const double by_springs = -rates[system.vx_of(middle)] / amplitude;
    system.rhs(0, moving, rates);
    const double by_dampers = -rates[system.vx_of(middle)] / amplitude;
    const double near = 4 / mass * std::sin(q / 2) * std::sin(q / 2);
    const double far = 4 / mass * std::sin(q) * std::sin(q);
    const std::string name = ", q = " + std::to_string(k) + "/16 pi";
    expect("omega^2 [1/s^2]" + name, by_springs, stiffness * near + skip * far,
           absolute(1.1e-11, "round-off of four stretches: 4 (k + kb)/m times half an ulp of 0.8 m against 20 mm"));
    expect("decay [1/s]" + name, by_dampers, 50 * near + 30 * far,
           absolute(1e-12,
                    "round-off: springs at rest, good to an ulp of 0.8 m, (k + kb)/m 1e-16 m/s^2, "
                    "against 0.02 m/s, and eight terms of up to 50 1/s"));
  }
}

}  // namespace
}  // namespace furrow::verification
