// Longitudinal plane waves of a chain with skip-one springs, by its forces on displaced and on moving nodes.
//
//   m u_n'' = k (u_(n+1) - 2 u_n + u_(n-1)) + kb (u_(n+2) - 2 u_n + u_(n-2)),  and the same with dampers c, cb on u'
//   w^2 = 4 k/m sin^2(q/2) + 4 kb/m sin^2(q)
//
// Source: Brillouin, Wave Propagation in Periodic Structures, chapters 1 to 3.
#include <cmath>
#include <string>

#include "run/system.h"
#include "verification/chain.h"
#include "verification/check.h"

namespace furrow::verification::chain_modes {
namespace {

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
}  // namespace furrow::verification::chain_modes
