// What a tear costs, and that nothing of the link is left: no energy, no memory of its force, no healing.
//
//   energy lost with a link:  F^2/(2 k)
//   afterwards the mass flies uniformly, or on a parabola under a load
//
// Source: algebra.
#include <cmath>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/tear_scenes.h"

namespace furrow::verification::tear {
namespace {

TEST(Tear, TakesTheEnergyOfItsSpringAndNoMore) {
  requirement("tear.energy");
  constexpr double v0 = 0.06, step = 1e-3;  // m/s, s
  const Torn torn = run_and_tear(spring_scene({.column = 1, .velocity = {v0, 0}}), step, 1);
  const double time = std::ceil(std::asin(omega * x_c / v0) / omega / step) * step;
  const double force = stiffness * v0 / omega * std::sin(omega * time);
  const Energies energy = observe(torn.ran.system, 1, torn.ran.y).energy;
  const char* reason =
      "truncation of rk4 at omega h = 0.01: (omega h)^4/120 a radian over 0.7 rad, doubled, and 1e-9 "
      "times the slope of the energy";
  expect("force at the tear [N]", torn.tears.at(0).force, force, relative(1.5e-10, reason));
  expect("tear energy [J]", energy.tear, 0.5 * force * force / stiffness, relative(3e-10, reason));
  expect("kinetic energy afterwards [J]", energy.kinetic, 0.5 * mass * v0 * v0 - 0.5 * force * force / stiffness,
         relative(3e-10, reason));
  expect("spring energy afterwards [J]", energy.springs, 0, exact("there is no spring"));
}

TEST(Tear, MultistepMethodsForgetTheTornLink) {
  requirement("tear.forgotten");
  for (const char* method : {"pece", "verlet", "odeint_abm2"}) {
    double time = 0, place = 0, speed = 0;  // s, m, m/s: at the tear
    const Ran ran = run_scene(spring_scene({.column = 1, .velocity = {0.06, 0}}), method, 1e-3, 1,
                              [&](double t, const State& y, const JumpReport& jump) {
                                if (!jump.torn.empty()) time = t, place = y[0], speed = y[2];
                                return true;
                              });
    expect("place at the end [m], " + std::string(method), ran.y[0], place + speed * (1 - time),
           absolute(1.3e-14,
                    "uniform motion: round-off of 900 steps, half an ulp of 0.14 m each and of one sign at worst; "
                    "one remembered force would be h^2 a/4 = 1e-7 m"));
  }
}

TEST(Tear, NothingHeals) {
  requirement("tear.for_ever");
  // Torn at the start, then pushed back through its rest length: a parabola.
  Scene scene = spring_scene({.column = 1, .displacement = {2 * x_c, 0}, .force = {-0.1, 0}});
  scene.lattice[0].structural.damping = 40;
  System system(scene);
  State y = system.initial_state();
  for (const double start : {0.0, 1.0})  // the second half with a fresh method
    run(system, *make_method("pece"), y, {.start = start, .end = start + 1, .step = 1e-3, .stop = {}},
        [](double, const State&, const JumpReport&) { return true; });
  expect("position after 2 s [m]", y[system.x_of(0)], spacing + 2 * x_c - 0.5 * 0.1 / mass * 2 * 2,
         absolute(3e-15,
                  "pece is exact on a parabola; round-off of 2000 steps, half an ulp of 0.1 m each, as a random "
                  "walk, and of the sums of the speed"));
  expect_true("still torn", system.torn(0), "no link is ever mended");
}

}  // namespace
}  // namespace furrow::verification::tear
