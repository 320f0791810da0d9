// A chain under tension whose end link tears unloads by a wave that moves one node in sqrt(m/k).
//
//   chain under tension T whose end comes free at t = 0; node j = 0, 1, ... from the end, z = 2 w t, w = sqrt(k/m):
//     v_j = T/sqrt(k m) (2j+1) int_0^z J_(2j+1)(s)/s ds
//         = T/sqrt(k m) (J_(2j+1)(z) + 2 sum_(i>0) J_(2j+1+2i)(z))
//     v_j sqrt(k m)/T -> 1/3 at z = 2j + 1, and 1 later
//   the same from a unit impulse on a node of an endless chain, J_(2|j|)(z)/m (Schroedinger), integrated by Simpson's
//   rule; with its mirror image it gives the free end:
//     v_j' = T (J_(2j)(z) + J_(2j+2)(z))/m
//     J_n(z) = 1/pi int_0^pi cos(n a - z sin a) da
//
// Source: Schroedinger 1914 (Ann. Phys. 44, 916); the free end by its mirror image, and J_(n-1) + J_(n+1) = 2n/z J_n.
#include <numbers>

#include "verification/bare_lattice.h"
#include "verification/check.h"
#include "verification/running.h"

namespace furrow::verification {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double spacing = 0.1;    // m
constexpr double mass = 5;         // kg
constexpr double stiffness = 500;  // N/m
constexpr double omega = 10;       // rad/s, sqrt(500 / 5)
constexpr double strength = 2;     // N
constexpr double tension = 1;      // N
constexpr int columns = 62;
constexpr double z = 60;  // -, at the end: the wave is half way

// sqrt(k m)/T v_j, and the same by integration.
double step_response(int j) {
  double sum = std::cyl_bessel_j(2.0 * j + 1, z);
  for (int n = 2 * j + 3; n < 2 * j + 3 + 4 * z; n += 2) sum += 2 * std::cyl_bessel_j(static_cast<double>(n), z);
  return sum;
}

double integrated_response(int j) {
  constexpr int intervals = 2000;
  const auto rate = [j](double s) {  // J_(2j) + J_(2j+2): twice the velocity after a unit impulse, by Bessel's integral
    double sum = 0;
    for (int a = 0; a < 200; ++a) {
      const double angle = pi * (a + 0.5) / 200;
      sum += std::cos(2 * j * angle - s * std::sin(angle)) + std::cos((2 * j + 2) * angle - s * std::sin(angle));
    }
    return sum / 200;
  };
  double sum = rate(0) + rate(z);
  for (int i = 1; i < intervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * rate(z * i / intervals);
  return 0.5 * sum * z / (3 * intervals);
}

TEST(UnloadingWave, FreeEndUnloadsTheChainAsAWave) {
  requirement("tear.unloading_wave");
  Scene scene = bare_lattice(1, columns, spacing, mass);
  scene.lattice[0].structural = {.stiffness = stiffness, .strength = strength};
  scene.lattice[0].fixed_columns = {0};
  for (int n = 1; n < columns; ++n) {
    const double stretch = tension / stiffness * (n == columns - 1 ? n + 1.5 : n);  // the last link: 2.5 T > S
    scene.lattice[0].node.push_back({.column = n, .displacement = {stretch, 0}});
  }
  double torn = 0;
  const Ran ran =
      run_scene(scene, "rk4", 0.005 / omega, z / (2 * omega), [&](double, const State&, const JumpReport& jump) {
        torn += static_cast<double>(jump.torn.size());
        return true;
      });
  expect("links torn", torn, 1, exact("the last link, at the start"));
  const double impedance = std::sqrt(stiffness * mass);  // kg/s
  double front = 0;
  for (int j = 0; j < 40; ++j) {
    const double v = -ran.y[ran.system.vx_of(columns - 3 - j)] * impedance / tension;
    front += v > 1.0 / 3 ? 1 : 0;
    if (j % 8 != 0) continue;
    const std::string node = ", node " + std::to_string(j);
    expect("closed form against the integral" + node, integrated_response(j), step_response(j),
           absolute(
               1e-9,
               "Simpson's rule at steps of 0.03: (0.03)^4/180 times the change of the third derivative, 0.1; doubled"));
    expect("speed after w t = 30, times sqrt(k m)/T" + node, v, step_response(j),
           absolute(2.5e-10, "truncation of rk4: C (2 w h)^4, measured once as 1.1e-10 and doubled"));
  }
  expect("nodes that the front has passed after w t = 30", front, 30,
         absolute(1, "the front moves one node in 1/w; a third of the speed is there when z = 2j + 1, for great j"));
}

}  // namespace
}  // namespace furrow::verification
