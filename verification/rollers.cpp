// Two nodes on rollers, joined by a spring along the way that is left to them, with loads along it and across.
//
//   along:   centre (F1 + F2)/(4 m) t^2,  stretch (F2 - F1)/(2 k) (1 - cos wt),  w = sqrt(2 k/m)
//   across:  the rollers take the load, nothing moves
//
// Source: algebra.
#include <cmath>
#include <string>

#include "verification/bare_lattice.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification::rollers {
namespace {

constexpr double k = 400, mass = 0.25, spacing = 0.05;           // N/m, kg, m
constexpr double first = 0.3, second = 1.1, across[] = {3, -2};  // N
constexpr double end = 0.1;                                      // s

TEST(Rollers, LeaveANodeFreeAlongThemAndHoldItAcross) {
  requirement("lattice.rollers");
  for (const bool along_y : {true, false}) {
    Scene scene = bare_lattice(along_y ? 2 : 1, along_y ? 1 : 2, spacing, mass);
    scene.lattice[0].structural.stiffness = k;
    for (const int n : {0, 1}) {
      const double along = n == 0 ? first : second;
      NodeSetting node{.row = along_y ? n : 0, .column = along_y ? 0 : n};
      node.force = along_y ? Vec2{across[n], along} : Vec2{along, across[n]};
      (along_y ? node.fixed_x : node.fixed_y) = true;
      scene.lattice[0].node.push_back(node);
    }
    const Ran ran = run_scene(scene, "rk4", end / 1000, end);
    const State start = ran.system.initial_state();
    const auto moved = [&](int node, bool y) {
      const int at = y ? ran.system.y_of(node) : ran.system.x_of(node);
      return ran.y[at] - start[at];
    };
    const std::string way = along_y ? ", along y" : ", along x";
    const double w = std::sqrt(2 * k / mass);
    expect("centre [m]" + way, (moved(0, along_y) + moved(1, along_y)) / 2, (first + second) / (4 * mass) * end * end,
           relative(1e-14, "rk4 is exact under a constant acceleration; round-off of 1,000 steps"));
    expect("stretch [m]" + way, moved(1, along_y) - moved(0, along_y),
           (second - first) / (2 * k) * (1 - std::cos(w * end)),
           relative(1e-9, "rk4: error of the phase w t (w h)^4/120 = 5e-11, times sin wt/(1 - cos wt) = 3.1"));
    for (const int n : {0, 1}) {
      const std::string which = ", node " + std::to_string(n) + way;
      expect("moved across [m]" + which, moved(n, !along_y), 0, exact("a roller takes the force"));
      expect("speed across [m/s]" + which, ran.y[along_y ? ran.system.vx_of(n) : ran.system.vy_of(n)], 0,
             exact("a roller takes the force"));
    }
  }
}

}  // namespace
}  // namespace furrow::verification::rollers
