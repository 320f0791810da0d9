// A damped disc that may be pulled back (`pull = true`) has the restitution asked for, whatever the speed.
//
//   m d'' = -K d^(3/2) - sqrt(5) beta sqrt(K m) d^(1/4) d',  so p = d^(5/4) is a linear oscillator in ds = d^(1/4) dt
//   e = exp(-pi beta / sqrt(1 - beta^2)),  that is  beta = -ln e / sqrt(ln^2 e + pi^2)
//   turn = sqrt(5)/2 sqrt(1 - beta^2)
//   d_max = p^(4/5) at s = acos(beta)/turn
//   t_c = int p^(-1/5) ds from 0 to pi/turn
//
// Lengths are in units of L = (m v^2/K)^(2/5), times in L/v.
//
// Source: Antypov and Elliott 2011 (Europhys. Lett. 94, 50004); spheres of test 3 of Chung and Ooi 2011 (Granular
// Matter 13, 643): radius 2.5 mm at 3.9 m/s on a rigid wall.
#include <cmath>
#include <string>

#include "verification/damped_scenes.h"

namespace furrow::verification::damped_impact {
namespace {

TEST(DampedImpact, RestitutionAskedForIsGot) {
  requirement("normal.restitution");
  for (const Matter& m : {alumina, cast_iron}) {
    const Units u = units_of(m, 3.9);
    for (const double e : {0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1.0}) {
      const std::string what = std::string(m.name) + ", e = " + std::to_string(e);
      const DampedHertz exact(beta_of(e));
      const double last = static_cast<double>(exact.contact_time()) * u.time();
      Scene scene = scene_of(m, u.speed);
      scene.contact.restitution = e;
      const Impact got = measure(scene, u.mass, {"odeint_dopri5", last / steps, 1.1 * last, tolerance, u.length()});
      expect(what + ": speed after over before", got.rebound, e, controlled(150));
      expect(what + ": contact time [s]", got.contact_time, last, controlled(2));
    }
  }
}

// alpha is what stands for sqrt(5) beta in the equation above.
TEST(DampedImpact, TsujisCoefficientGivesTheRestitutionOfItsEquation) {
  requirement("normal.restitution");
  const Units u = units_of(alumina, 3.9);
  for (const double e : {0.2, 0.7}) {
    const double last = static_cast<double>(DampedHertz(beta_of(e)).contact_time()) * u.time();
    Scene scene = scene_of(alumina, u.speed);
    scene.contact.tsuji_alpha = 2.23606797749979 * beta_of(e);
    const Impact got = measure(scene, u.mass, {"odeint_dopri5", last / steps, 1.1 * last, tolerance, u.length()});
    expect("speed after over before, e = " + std::to_string(e), got.rebound, e, controlled(150));
  }
}

// Test 3 of the table at e = 1, where the exact solution is Hertz's.
TEST(DampedImpact, WithoutDampingItIsTheElasticImpactOfTheTable) {
  requirement("normal.restitution");
  const Units u = units_of(alumina, 3.9);
  const DampedHertz exact(0);
  const double deepest = static_cast<double>(exact.overlap(exact.turning())) * u.length();
  expect("d_max of the table [m]", 8.0888083e-6, deepest, last_digit(7e-9));
  expect("F_max of the table [N]", 615.35157, u.stiffness * deepest * std::sqrt(deepest), last_digit(1e-8));
  expect("t_c of the table [s]", 6.1045099e-6, static_cast<double>(exact.contact_time()) * u.time(), last_digit(1e-8));
  const Hertz h{u.mass, u.stiffness, u.speed};
  Scene scene = scene_of(alumina, u.speed);
  scene.contact.restitution = 1;
  expect_hertz("aluminium oxide, e = 1", h, scene, u.mass, 200);
}

// The damping of two unlike bodies is that of their reduced mass.
TEST(DampedImpact, RestitutionBetweenUnlikeBodiesIsGot) {
  requirement("normal.restitution");
  constexpr double e = 0.6;
  Scene scene = impact_scene(DiscMass::sphere);
  scene.model.pull = true;
  scene.contact.restitution = e;
  add_disc(scene, glass, 0.01, {0, 0}, {3, 0});
  add_disc(scene, cast_iron, 0.025, {0.035, 0}, {-1, 0});
  const double ma = mass_of(glass, 0.01, DiscMass::sphere);
  const double mb = mass_of(cast_iron, 0.025, DiscMass::sphere);
  const Units u{1 / (1 / ma + 1 / mb), hertz_stiffness(softness(glass) + softness(cast_iron), 1 / (100.0 + 40.0)), 4};
  const double last = static_cast<double>(DampedHertz(beta_of(e)).contact_time()) * u.time();
  const Impact got = measure(scene, ma, {"odeint_dopri5", last / steps, 1.1 * last, tolerance, u.length()});
  expect("speed after over before", got.rebound, e, controlled(150));
  expect("contact time [s]", got.contact_time, last, controlled(2));
  expect("first body's speed after [m/s]", got.y[4], 3 - (1 + e) * u.mass / ma * u.speed, controlled(150));
}

TEST(DampedImpact, RestitutionIsTheSameOverSixDecadesOfSpeed) {
  requirement("normal.restitution");
  constexpr double e = 0.5;
  const DampedHertz exact(beta_of(e));
  for (const double v : {1e-4, 1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2}) {
    const Units u = units_of(alumina, v);
    const double last = static_cast<double>(exact.contact_time()) * u.time();
    Scene scene = scene_of(alumina, v);
    scene.contact.restitution = e;
    const Impact got = measure(scene, u.mass, {"odeint_dopri5", last / steps, 1.1 * last, tolerance, u.length()});
    expect("speed after over before at " + std::to_string(v) + " m/s", got.rebound, e, controlled(150));
  }
}

}  // namespace
}  // namespace furrow::verification::damped_impact
