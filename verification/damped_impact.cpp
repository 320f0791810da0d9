// A damped disc that may be pulled back (`pull = true`) follows the exact solution of damped_hertz.h: the restitution
// asked for is the one got, whatever the speed, and at the paper's beta = 20 it creeps out and never leaves.
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
#include "run/observe.h"
#include "verification/damped_hertz.h"
#include "verification/impact.h"

namespace furrow::verification {
namespace {

constexpr double radius = 0.0025;  // m
constexpr double pi = 3.14159265358979323846;
constexpr double tolerance = 1e-12;  // of the controlled method, in units of the impact
constexpr int steps = 1000;          // in a contact time, at least

// A controlled method: the force starts as t^(1/4), where fixed steps are of order 5/4 only.
Tolerance controlled(double errors) {
  return relative(errors * tolerance, "error control: so many errors of 1e-12 add up, measured once, doubled");
}

struct Units {
  double mass, stiffness;  // kg, N/m^(3/2)
  double speed;            // m/s
  double length() const { return std::pow(mass * speed * speed / stiffness, 0.4); }
  double time() const { return length() / speed; }
};

Units units_of(const Matter& m, double speed) {
  return {mass_of(m, radius, DiscMass::sphere), hertz_stiffness(softness(m), radius), speed};
}

Scene scene_of(const Matter& m, double speed) {
  Scene scene = wall_impact(m, radius, speed, DiscMass::sphere, true);
  scene.model.pull = true;
  return scene;
}

double beta_of(double e) { return -std::log(e) / std::hypot(std::log(e), pi); }

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

// beta of the material pair goes before the one of the scene.
TEST(DampedImpact, FarAboveCriticalDampingItCreepsOut) {
  requirement("normal.damped");
  const Units u = units_of(cast_iron, 3.9);
  for (const double beta : {0.3, 1.0, 2.0, 20.0}) {
    const DampedHertz exact(beta);
    Scene scene = scene_of(cast_iron, u.speed);
    scene.contact.damping_factor = 7;
    scene.contact.pair.push_back({.materials = {"rigid", cast_iron.name}, .damping_factor = beta});
    for (const double turns : {0.25, 1.0, 1.5}) {
      const long double s = turns * exact.turning();
      const double end = static_cast<double>(exact.time(s)) * u.time();
      const Impact got = measure(scene, u.mass, {"odeint_dopri5", end / steps, end, tolerance, u.length()});
      const std::string what =
          "beta " + std::to_string(beta) + ", " + std::to_string(turns) + " of the way to the turn";
      expect(what + ": overlap [m]", -got.y[1], static_cast<double>(exact.overlap(s)) * u.length(), controlled(11));
      expect(what + ": speed over v", -got.y[3] / u.speed, static_cast<double>(exact.speed(s)),
             absolute(2.5 * tolerance, controlled(1).reason));
    }
  }
}

// What is missing from the motion is in the spring or has gone into the damping, at the turn and after the impact.
TEST(DampedImpact, LedgerHoldsTheLostEnergy) {
  requirement("normal.damped");
  constexpr double e = 0.5;
  constexpr int n = 2000;  // steps in a contact time
  const Units u = units_of(alumina, 3.9);
  const DampedHertz exact(beta_of(e));
  const double last = static_cast<double>(exact.contact_time()) * u.time();
  const double turn = static_cast<double>(exact.time(exact.turning())) * u.time();
  const double stored = 0.8 * static_cast<double>(std::pow(exact.overlap(exact.turning()), 2.5L));  // 2/5 K d^(5/2)
  Scene scene = scene_of(alumina, u.speed);
  scene.contact.restitution = e;
  scene.output.energy = true;
  const double whole = 0.5 * u.mass * u.speed * u.speed;  // J
  const auto truncation = [](double c) {
    return absolute(2 * c * std::pow(n, -1.25), "truncation of order 5/4, C measured once, doubled");
  };
  const Ran half = run_scene(scene, "rk4", last / n, turn);
  const Energies at_turn = observe(half.system, turn, half.y).energy;
  expect("at the turn: viscous work over m v^2/2", at_turn.contact_viscous / whole, 1 - stored, truncation(0.153));
  expect("at the turn: elastic energy over m v^2/2", at_turn.contact_elastic / whole, stored, truncation(0.153));
  const Ran whole_run = run_scene(scene, "rk4", last / n, 1.1 * last);
  const Energies after = observe(whole_run.system, whole_run.end.time, whole_run.y).energy;
  expect("after it: viscous work over m v^2/2", after.contact_viscous / whole, 1 - e * e, truncation(0.153));
  expect("after it: kinetic energy over m v^2/2", after.kinetic / whole, e * e, truncation(0.153));
}

TEST(DampedImpact, FixedStepsAreOfOrderFiveQuarters) {
  requirement("normal.damped");
  const Units u = units_of(alumina, 3.9);
  const DampedHertz exact(0.2);
  Scene scene = scene_of(alumina, u.speed);
  scene.contact.damping_factor = 0.2;
  const double end = static_cast<double>(exact.time(exact.turning())) * u.time();
  // After the leading term h^(5/4) come h^2 of pece and h^(5/2) of rk4: 1e-2 and 1e-4 of it at 800 steps.
  for (const auto& [method, next] : {std::pair{"pece", 2e-3}, {"rk4", 1e-4}}) {
    std::vector<double> lengths, errors;
    for (const int n : {800, 1600, 3200, 6400, 12800}) {
      const Impact got = measure(scene, u.mass, {method, end / n, end});
      lengths.push_back(1.0 / n);
      errors.push_back(std::fabs(-got.y[1] / u.length() - static_cast<double>(exact.overlap(exact.turning()))));
    }
    expect(std::string(method) + ": observed order", fitted_slope(lengths, errors), 1.25,
           absolute(next, "what the next term of the error adds to the slope, measured, times two or more"));
  }
}

}  // namespace
}  // namespace furrow::verification
