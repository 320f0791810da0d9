// The paper looks for the contact of a disc with a lattice at nodes and at auxiliary points between them.
//
//   at the height h above a segment, x beside the nearest of its n auxiliary points, x <= s/(2 (n + 1)):
//     distance sqrt(h^2 + x^2), along a line that leans by x/h
//
// Source: geometry.
#include <algorithm>
#include <cmath>
#include <string>

#include "run/observe.h"
#include "run/system.h"
#include "verification/check.h"
#include "verification/coupling_scenes.h"

namespace furrow::verification::coupling {
namespace {

TEST(Coupling, AuxiliaryPointsAreOffByNoMoreThanHalfTheirSpacing) {
  requirement("coupling.auxiliary_points");
  constexpr double height = 0.0095;  // m
  for (const int auxiliary : {0, 4, 9}) {
    const double furthest = auxiliary == 0 ? 0 : spacing / (2 * (auxiliary + 1));  // m
    double least = 1;
    double most = 0;
    double lean = 0;
    for (int k = 0; k <= 400; ++k) {
      Lattice edge{.columns = 2, .fixed_columns = {0, 1}};
      edge.auxiliary_points = auxiliary;
      const Scene scene = disc_above(edge, k * spacing / 400, height);
      const System system(scene);
      const State y = system.initial_state();
      const double depth = observe(system, 0, y).overlap.depth;
      least = std::min(least, depth);
      most = std::max(most, depth);
      if (depth == 0) continue;
      State rates(system.size());
      system.rhs(0, y, rates);
      lean = std::max(lean, std::fabs(rates[system.vx_of(0)] / rates[system.vy_of(0)]));
    }
    const std::string which = ", " + std::to_string(auxiliary) + " points";
    const double reach = std::hypot(height, furthest);
    expect("greatest overlap [m]" + which, most, radius - height, absolute(4e-18, "2 ulp of R"));
    expect("least overlap [m]" + which, least, std::fmax(0, radius - reach), absolute(4e-18, "2 ulp of R"));
    if (reach < radius)
      expect("greatest lean of the force" + which, lean, furthest / height,
             absolute(2e-15, "round-off of a quotient of small numbers"));
  }
}

}  // namespace
}  // namespace furrow::verification::coupling
