// With the paper's auxiliary points a joint of two segments is no worse than any other place of them.
//
//   9 points on segments of length s, a disc at the height h over them:
//     d is less than R - h by at most sqrt(h^2 + (s/20)^2) - h
//
// Source: geometry.
#include <algorithm>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/one_surface_scenes.h"

namespace furrow::verification::one_surface {
namespace {

TEST(OneSurface, AuxiliaryPointsMakeAJointNoWorse) {
  requirement("coupling.one_surface");
  constexpr double height = 0.009, spacing = 0.0625;  // m
  double least = 1, most = 0;
  for (int k = -400; k <= 400; ++k) {
    Floor floor = floor_of("fixed nodes", 0);
    floor.scene.lattice[0].auxiliary_points = 9;
    floor.scene.disc.push_back({{k * spacing / 400, height}, radius, {}, 0, "any"});
    const System system(floor.scene);
    const double depth = observe(system, 0, system.initial_state()).overlap.depth;
    least = std::min(least, depth);
    most = std::max(most, depth);
  }
  const double missing = std::hypot(height, spacing / 20) - height;
  expect("greatest overlap, across the joint [m]", most, radius - height, absolute(4e-18, "2 ulp of R"));
  expect("least overlap, across the joint [m]", least, radius - height - missing, absolute(4e-18, "2 ulp of R"));
}

}  // namespace
}  // namespace furrow::verification::one_surface
