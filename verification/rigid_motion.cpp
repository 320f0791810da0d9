// A lattice that is carried and turned as a whole feels nothing.
//
//   axial damper: two nodes that turn about each other at rate W, m* = m/2, keep on turning:
//     k (l' - l) = m* W^2 l'
//     r(t) = l' (cos W t, sin W t)
//
// Source: the equations of motion.
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

}  // namespace
}  // namespace furrow::verification::rigid_motion
