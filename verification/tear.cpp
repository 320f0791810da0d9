// When a link tears.
//
//   a link tears when its spring force exceeds its strength S, at the stretch x_c = S/k
//   pulled by a plate at speed v through a contact F = 4/3 E* sqrt(R) d^(3/2):
//     v t = x_c + (S/(4/3 E* sqrt(R)))^(2/3)
//   step load F0 on a mass at rest, tears if F0 > S/2:
//     x = F0/k (1 - cos wt)
//   impulse v0, tears if v0 > w x_c:
//     x = v0/w sin wt
//     t = asin(w x_c/v0)/w
//
// Source: algebra.
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/tear_scenes.h"

namespace furrow::verification::tear {
namespace {

// The greatest value up to `high` at which `tears` is still false, by bisection.
template <class Tears>
double threshold(double high, const Tears& tears) {
  double low = 0;
  while (high - low > 1e-13 * high) (tears(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return low;
}

TEST(Tear, SlowPullTearsAtTheStrength) {
  requirement("tear.at_strength");
  constexpr double speed = 1e-3, step = 1e-3;  // m/s, s
  Scene scene = spring_scene({.column = 1});
  scene.lattice[0].node_mass = 0.01;
  scene.lattice[0].structural.damping = 1;
  scene.plate.push_back(
      {.left_edge = spacing - 0.01, .lower_edge = -0.05, .velocity = {speed, 0}, .material = "rigid"});
  const Torn torn = run_and_tear(scene, step, 8);
  const double contact = 4.0 / 3 * 2e5 / (1 - 0.3 * 0.3) * std::sqrt(scene.lattice[0].contact_radius);
  const double time = (x_c + std::pow(strength / contact, 2.0 / 3)) / speed;
  expect("links torn", static_cast<double>(torn.tears.size()), 1, exact("one link"));
  const Tear& tear = torn.tears.at(0);
  expect("time of the tear [s]", tear.time, time + step / 2,
         absolute(step / 2 + 1e-4, "seen at the end of a step; the damper's 1 mN presses the contact by 0.1 um more"));
  expect("force at the tear [N]", tear.force, strength + stiffness * speed * step / 2,
         absolute(stiffness * speed * step / 2, "the first step beyond the strength: at most k v h above it"));
}

TEST(Tear, StepLoadTearsFromHalfTheStrength) {
  requirement("tear.step_load");
  const double critical = threshold(strength, [](double force) {
    return !run_and_tear(spring_scene({.column = 1, .force = {force, 0}}), pi / omega / 200, 4 * pi / 3 / omega)
                .tears.empty();
  });
  expect("critical load [N]", critical, strength / 2,
         relative(2.1e-11,
                  "rk4 at omega h = pi/200 with a step at the very peak: its amplitude falls by (omega h)^6/144 a "
                  "step, half of the peak by 2.1e-11 in 200 steps, the peak by 1e-11; doubled"));
}

TEST(Tear, ImpulseTearsWhenTheStretchGetsThere) {
  requirement("tear.impulse");
  constexpr double step = 1e-3;  // s
  const double critical = threshold(2 * omega * x_c, [](double speed) {
    return !run_and_tear(spring_scene({.column = 1, .velocity = {speed, 0}}), pi / omega / 200, pi / omega)
                .tears.empty();
  });
  expect(
      "critical speed [m/s]", critical, omega * x_c,
      relative(2.1e-11,
               "rk4 at omega h = pi/200 with a step at the very peak: (omega h)^6/144 a step over 100 steps, doubled"));
  for (const double excess : {1.01, 1.5, 4.0}) {
    const Torn torn = run_and_tear(spring_scene({.column = 1, .velocity = {excess * omega * x_c, 0}}), step, 1);
    const double steps = std::ceil(std::asin(1 / excess) / omega / step);
    expect("steps until it tears, v0 = " + std::to_string(excess) + " w x_c", torn.tears.at(0).time / step, steps,
           absolute(1e-12, "the first step after the exact time; round-off of n h / h"));
  }
}

}  // namespace
}  // namespace furrow::verification::tear
