// A disc falls on the upper of two free nodes with a spring between them: the impact is that of three bodies in a line.
//
//   m_disc y_d'' = F,  m_n y_u'' = -F - k s,  m_n y_l'' = k s
//   F = K d^(3/2),  d = y_u - y_d,  s = y_u - y_l
//
// Heights are counted from where each is at the touch. Oracle: three_bodies.h, in long double.
//
// Source: Newton and Hertz.
#include <algorithm>
#include <cmath>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/running.h"
#include "verification/three_bodies.h"

namespace furrow::verification::coupling {
namespace {

TEST(Coupling, SprungMassTakesMomentumAndEnergyOver) {
  requirement("coupling.impact");
  const double reduced = reduced_mass(1 / node_mass);
  const double time = 2.943275184324047 * deepest(reduced) / closing;
  const double end = 1.6 * time;  // s, the disc has left
  const double alone = 2 * reduced * closing / node_mass;
  expect("upper node by integration, no spring [m/s]", static_cast<double>(three_bodies(0, end, 20000).upper), -alone,
         relative(5e-12, "truncation: 2.4e-12 measured, doubled"));
  for (const double spring : {100.0, 1e4}) {
    const Line want = three_bodies(spring, end, 20000);
    const Scene scene =
        disc_above({.origin = {0, -spacing}, .rows = 2, .structural = {.stiffness = spring}}, 0, radius * (1 - 1e-14));
    const System system(scene);
    double worst = 0;
    const Ran ran = run_scene(scene, "verlet", end / 20000, end, [&](double t, const State& y, const JumpReport&) {
      worst = std::max(worst, std::fabs(observe(system, t, y).momentum.y / (-disc_mass * closing) - 1));
      return true;
    });
    const std::string which = ", k " + std::to_string(int(spring)) + " N/m";
    const Tolerance truncation = absolute(1.3e-8, "truncation of order 2: 6.3e-9 measured at 20000 steps, doubled");
    const auto v = [&](int body) { return ran.y[ran.system.vy_of(body)] / closing; };
    expect("disc, velocity / v" + which, v(0), static_cast<double>(want.disc) / closing, truncation);
    expect("upper node, velocity / v" + which, v(2), static_cast<double>(want.upper) / closing, truncation);
    expect("lower node, velocity / v" + which, v(1), static_cast<double>(want.lower) / closing, truncation);
    expect("greatest error of momentum" + which, worst, 0,
           absolute(4e-14, "round-off over 20000 steps: 1.7e-14 measured, doubled"));
    expect("energy / m v^2 / 2" + which,
           observe(system, end, ran.y).energy.stored() / (0.5 * disc_mass * closing * closing), 1,
           relative(2.4e-9, "truncation of order 2: 1.2e-9 measured, doubled"));
  }
}

}  // namespace
}  // namespace furrow::verification::coupling
