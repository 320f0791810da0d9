// The stress of a disc on which friction acts, under loads that are known by hand.
//
//   sigma = (1/V) sum over contacts of b (x) F, symmetric part, as in particle_stress.cpp
//   spinning between two walls, sliding:  syy = -2 b F/V, sxy = mu b F/V (the other half of 2 mu b F turns the disc)
//   spinning between four walls:          sxy = 0: a pure torque has no symmetric part
//   four springs of force T, pure shear:  sxy = 2 b T/V;                     von Mises sqrt((2 b F)^2 + 3 (2 b T)^2)/V
//
// Source: statics, by hand.
#include <cmath>
#include <vector>

#include "kernel/kernel.h"
#include "verification/boxed_disc.h"

namespace furrow::verification::particle_stress {
namespace {

// Sliding fast, so that every contact is at the Coulomb limit mu F.
Stress sliding(const std::vector<Side>& sides, double spin, double speed) {
  Scene scene = boxed(sides);
  scene.contact.friction = friction;
  scene.contact.damping_factor = 0.5;
  scene.disc[0].spin = spin;
  scene.disc[0].velocity.x = speed;
  return stress_of(scene);
}

TEST(ParticleStress, FrictionAddsItsSymmetricShear) {
  requirement("stress.friction");
  const double pressure = 2 * arm * force / disc_volume;
  expect_stress("spinning between two walls", sliding({below, above}, 1e4, 0), 0, -pressure, friction * pressure / 2);
  expect_stress("spinning the other way", sliding({below, above}, -1e4, 0), 0, -pressure, -friction * pressure / 2);
  expect_stress("sliding along two walls", sliding({below, above}, 0, 100), 0, -pressure, 0);
  expect_stress("spinning between four walls", sliding({left, right, below, above}, 1e4, 0), -pressure, -pressure, 0);
}

// Tangential springs that are stretched by hand: they push left at the bottom, right at the top, up at the right and
// down at the left.
TEST(ParticleStress, PureShear) {
  requirement("stress.friction");
  Scene scene = boxed({left, right, below, above});
  scene.contact.friction = friction;
  System system(scene);
  State y = system.initial_state();
  system.jump(0, y);  // gives the contacts their springs
  // G*: 1/G* = (2 - nu)/G = 2 (2 - nu)(1 + nu)/E for a rigid partner.
  const double shear_modulus = soil.young / (2 * (2 - soil.poisson) * (1 + soil.poisson));
  const double stiffness = 8 * shear_modulus * std::sqrt(radius * overlap);
  const double stretch = 0.2 * friction * force / stiffness;  // m, far from the limit
  const auto& walls = kernel_of(system.solver()).search().candidates[disc_wall];
  for (int k = 0; k < walls.count(); ++k) {
    const bool upright = walls.b[k] == left || walls.b[k] == right;
    y[system.first_spring() + walls.slot[k]] = upright ? -stretch : stretch;
  }
  const double pressure = 2 * arm * force / disc_volume;
  const double shear = 2 * arm * stiffness * stretch / disc_volume;
  expect_stress("four springs", disc_stresses(system, 0, y)[0], -pressure, -pressure, shear);
}

}  // namespace
}  // namespace furrow::verification::particle_stress
