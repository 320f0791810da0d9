// What a damped impact does on its way: at the paper's beta = 20 it creeps out and never leaves, its energy is in the
// ledger, and fixed steps are of order 5/4.
//
//   overlap, speed and time by the exact solution of damped_hertz.h
//   energy, over m v^2/2:  4/5 d_max^(5/2) in the spring at the turn, 1 - e^2 lost afterwards
//   order:                 the force starts as t^(1/4), so min(p, 1/4 + 1)
//
// Source: Antypov and Elliott 2011 (Europhys. Lett. 94, 50004).
#include <cmath>
#include <string>
#include <vector>

#include "run/observe.h"
#include "verification/damped_scenes.h"

namespace furrow::verification::damped_impact {
namespace {

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
}  // namespace furrow::verification::damped_impact
