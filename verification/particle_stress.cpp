// The stress of a disc under loads that are known by hand.
//
//   sigma = (1/V) sum over contacts of b (x) F, symmetric part;  b from the centre to the contact, F on the disc
//   von Mises in the plane: sqrt(sxx^2 - sxx syy + syy^2 + 3 sxy^2)
//   pressed by F on two opposite sides:   sxx = -2 b F/V, nothing else;      von Mises 2 b F/V
//   pressed by F on all four sides:       sxx = syy = -2 b F/V, sxy = 0;     von Mises 2 b F/V
//
// Source: statics, by hand; the formula as in Rojek, Karlis, Malinowski and Beer 2013. F = 4/3 E* sqrt(R) d^(3/2) at an
// overlap of d; b = R - d, or R with `moment_arm = "radius"`.
#include <cmath>

#include "verification/boxed_disc.h"

namespace furrow::verification::particle_stress {
namespace {

TEST(ParticleStress, PressedBetweenTwoWalls) {
  requirement("stress.normal");
  const double pressure = 2 * arm * force / disc_volume;
  expect_stress("left and right", stress_of(boxed({left, right})), -pressure, 0, 0);
  expect_stress("below and above", stress_of(boxed({below, above})), 0, -pressure, 0);
  Scene leaning = boxed({});
  for (const double sign : {1.0, -1.0}) {
    leaning.wall.push_back(
        {.point = {-sign * 0.6 * arm, -sign * 0.8 * arm}, .normal = {sign * 0.6, sign * 0.8}, .material = "rigid"});
  }
  expect_stress("along (0.6, 0.8)", stress_of(leaning), -0.36 * pressure, -0.64 * pressure, -0.48 * pressure);
}

TEST(ParticleStress, PressedFromAllSides) {
  requirement("stress.normal");
  const double pressure = 2 * arm * force / disc_volume;
  expect_stress("four walls", stress_of(boxed({left, right, below, above})), -pressure, -pressure, 0);
}

// A smaller disc pressed against a larger one, each held by a wall behind it: every contact has its own arm.
TEST(ParticleStress, TwoDiscsInARow) {
  requirement("stress.normal");
  constexpr double small = 0.01;    // m
  constexpr double between = 5e-4;  // m, overlap of the two
  Scene scene = boxed({left});
  add_disc(scene, {"soft", 1e5, 0.3, 1000}, small, {radius + small - between, 0}, {0, 0});
  scene.wall.push_back(
      {.point = {radius + 2 * small - between - overlap / 2, 0}, .normal = {-1, 0}, .material = "rigid"});
  const Matter soft{"soft", 1e5, 0.3, 1000};
  const double middle =
      hertz_stiffness(softness(soil) + softness(soft), 1 / (1 / radius + 1 / small)) * std::pow(between, 1.5);
  const double outer = hertz_stiffness(softness(soft), small) * std::pow(overlap / 2, 1.5);
  const System system(scene);
  const auto got = disc_stresses(system, 0, system.initial_state());
  expect_stress("larger disc", got[0], -(arm * force + (radius - between / 2) * middle) / disc_volume, 0, 0);
  expect_stress("smaller disc", got[1],
                -((small - overlap / 2) * outer + (small - between / 2) * middle) / (pi * small * small), 0, 0);
}

TEST(ParticleStress, VolumeAndArmAreThoseOfTheReading) {
  requirement("stress.volume");
  const double sphere = 2 * arm * force / (4.0 / 3.0 * pi * radius * radius * radius);
  expect_stress("sphere", stress_of(boxed({left, right}, DiscMass::sphere)), -sphere, 0, 0);
  Scene deep = boxed({left, right});
  deep.model.disc_depth = 0.25;
  expect_stress("disc 0.25 m deep", stress_of(deep), -8 * arm * force / disc_volume, 0, 0);
  Scene whole = boxed({left, right});
  whole.model.moment_arm = MomentArm::radius;
  expect_stress("whole radius as arm", stress_of(whole), -2 * radius * force / disc_volume, 0, 0);
}

}  // namespace
}  // namespace furrow::verification::particle_stress
