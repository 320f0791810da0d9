// A lattice that is carried and turned as a whole feels nothing; the two misprinted equations of the paper do harm at
// known rates.
//
//   axial damper: two nodes that turn about each other at rate W, m* = m/2, keep on turning:
//     k (l' - l) = m* W^2 l'
//     r(t) = l' (cos W t, sin W t)
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
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/carried_lattice.h"
#include "verification/check.h"

namespace furrow::verification::rigid_motion {
namespace {

TEST(RigidMotion, GivesNoForce) {
  requirement("lattice.rigid_motion");
  const System system(lattice_scene(3, 4, Damper::axial));
  for (const double angle : {0.0, 0.7, 2.0, pi}) {
    expect("greatest force in translation and rotation [N], turned by " + std::to_string(angle),
           forces(system, moved(system, angle, spin, {3, -5})).greatest, 0,
           absolute(1.5e-12,
                    "round-off: up to twelve links of up to 3000 N/m with lengths good to an ulp of 0.3 m, "
                    "6e-17, and dampers of up to 21 N s/m with speeds good to an ulp of 5 m/s, 9e-16"));
  }
}

TEST(RigidMotion, HasWeightOnlyIfAskedFor) {
  requirement("lattice.weight");
  for (const bool weighs : {false, true}) {
    Scene scene = lattice_scene(3, 4, Damper::axial);
    scene.model.gravity = 9.81;
    scene.lattice[0].gravity = weighs;
    const System system(scene);
    const State y = system.initial_state();
    State rates(y.size());
    system.rhs(0, y, rates);
    for (const int node : {0, 5, 11}) {
      expect("acceleration upwards [m/s^2], node " + std::to_string(node) + (weighs ? " of a heavy lattice" : ""),
             rates[system.vy_of(node)], weighs ? -9.81 : 0,
             absolute(5e-13,
                      "round-off: up to twelve links of up to 3000 N/m with lengths good to an ulp of 0.3 m, "
                      "6e-17, at rest, on 2 kg"));
    }
  }
}

TEST(RigidMotion, TranslationStaysUniform) {
  requirement("lattice.rigid_motion");
  System system(lattice_scene(3, 4, Damper::full));
  State y = moved(system, 0.7, 0, {3, -5});
  const State start = y;
  run(system, *make_method("pece"), y, {.start = 0, .end = 0.5, .step = 1e-3, .stop = {}},
      [](double, const State&, const JumpReport&) { return true; });
  double worst = 0;
  for (int n = 0; n < system.parts().node.count(); ++n) {
    worst = std::max(worst, std::fabs(y[system.x_of(n)] - start[system.x_of(n)] - 1.5));
    worst = std::max(worst, std::fabs(y[system.y_of(n)] - start[system.y_of(n)] + 2.5));
  }
  expect("distance from the uniform motion after 3.5 m [m]", worst, 0,
         absolute(5e-14, "round-off: 500 steps, each of them half an ulp of 2.5 m, 2e-16, of one sign at worst"));
}

TEST(RigidMotion, AxialDampersLetItTurnForEver) {
  requirement("lattice.rotation_kept");
  const Turning end = turn(Damper::axial);
  const char* truncation =
      "truncation of rk4 by the stiff radial motion: (omega h)^4/120 (W/omega)^2 a radian, 2.7e-10 over 2 rad; "
      "its constant measured once, 2, and doubled";
  expect("x / l' after 2 rad", end.x, std::cos(2.0), absolute(1.1e-9, truncation));
  expect("y / l' after 2 rad", end.y, std::sin(2.0), absolute(1.1e-9, truncation));
  const char* rounding = "round-off: an ulp of one a step, 2e-16, over 500 steps and of one sign at worst";
  expect("angular momentum after 2 rad, of its start", end.angular, 1, absolute(1e-13, rounding));
  expect("energy after 2 rad, of its start", end.energy, 1, absolute(1e-13, rounding));
}

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
