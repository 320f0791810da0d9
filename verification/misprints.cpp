// The two misprinted equations of the paper do harm at known rates.
//
//   full damper (Eq. 2 as printed), whatever the springs do:
//     L' = -c r x r' = -(c/m*) L
//     L = L0 e^(-c t/m*)
//     a lattice in rigid rotation is braked by the moment  -W sum over links of c l^2
//   Eq. (1) as printed, k < 0; one root is positive:
//     m x'' + c x' - |k| x = 0
//     x = x0 (r1 e^(r2 t) - r2 e^(r1 t))/(r1 - r2)
//     r = -c/(2m) +- sqrt(c^2/(4m^2) + |k|/m)
//
// Source: the equations of motion; the misprints are listed in validation/decisions.md.
#include <cmath>

#include "verification/carried_lattice.h"
#include "verification/check.h"

namespace furrow::verification::rigid_motion {
namespace {

TEST(RigidMotion, FullDampersBrakeTheRotationAtTheirRate) {
  requirement("lattice.full_damper_brakes");
  const Turning end = turn(Damper::full);
  const double rate = damping / (mass / 2);  // 1/s
  expect("angular momentum after 0.5 s, of its start", end.angular, std::exp(-rate * 0.5),
         relative(1.4e-10, "truncation of rk4: (rate h)^4/120 over 3.5 time constants, 7e-11, doubled"));
  const System system(lattice_scene(3, 4, Damper::full));
  // 17 structural links of length s, 12 diagonals, 10 of length 2 s
  const double sum = damping * spacing * spacing * (17 * 1 + 12 * 2 * 2 + 10 * 4 * 3);
  expect("moment on a lattice in rigid rotation [N m]", forces(system, moved(system, 0.7, spin, {3, -5})).moment,
         -spin * sum, absolute(5e-14, "round-off of the sum over 39 links"));
}

TEST(RigidMotion, TheSpringAsPrintedFliesApart) {
  requirement("lattice.printed_spring_flies_apart");
  Scene scene = lattice_scene(1, 2, Damper::axial);
  scene.lattice[0].fixed_columns = {0};
  scene.lattice[0].structural = {.stiffness = -500, .damping = 10};
  scene.lattice[0].node.push_back({.column = 1, .displacement = {1e-3, 0}});
  const Ran ran = run_scene(scene, "rk4", 1e-3, 0.3);
  const double r1 = -10 / (2 * mass) + std::sqrt(10 / (2 * mass) * 10 / (2 * mass) + 500 / mass);
  const double r2 = -10 / (2 * mass) - std::sqrt(10 / (2 * mass) * 10 / (2 * mass) + 500 / mass);
  const double grown = (r1 * std::exp(r2 * 0.3) - r2 * std::exp(r1 * 0.3)) / (r1 - r2);
  expect("stretch after 0.3 s, of its start", (ran.y[ran.system.x_of(0)] - spacing) / 1e-3, grown,
         relative(2.4e-9, "truncation of rk4: (r1 h)^5/120 a step over 300 steps, r1 = 13.5 1/s, doubled"));
}

}  // namespace
}  // namespace furrow::verification::rigid_motion
