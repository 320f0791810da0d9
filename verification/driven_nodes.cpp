// A driven node draws a mass by a spring, from rest, with a ramp T and at once (T = 0).
//
//   x = stretch of the spring, w = sqrt(k/m), acceleration a = v/T in the ramp
//     in the ramp       x = -a/w^2 (1 - cos wt)
//     T = n 2 pi/w:     x = 0 afterwards; work put in: m v^2/2
//     T = 0:            x = -v/w sin wt; work put in: m v^2 (1 - cos wt)
//   force on the driven node k x; work = force times way; two rows of n such pairs: n times as much
//   a stem between a fixed row and a driven one that goes down by u; the half row at each holds its width, EA 9/8 there
//   at nu = 1/3:  F = EA u/(L - s/9)
//
// Source: algebra.
#include <cmath>
#include <string>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/running.h"
#include "verification/stem_scenes.h"

namespace furrow::verification::driven_nodes {
namespace {

constexpr double k = 400, mass = 0.25, speed = 0.2;  // N/m, kg, m/s
const double omega = std::sqrt(k / mass);            // rad/s

// Columns 1 are drawn by columns 0, row by row.
Scene drawn(int rows, double ramp) {
  Scene scene = bare_lattice(rows, 2, 0.05, mass);
  scene.lattice[0].structural.stiffness = k;
  scene.lattice[0].drive = {{.columns = {0}, .velocity = {-speed, 0}, .ramp = ramp}};
  return scene;
}

TEST(DrivenNodes, DrawAMassFromRest) {
  requirement("driven.at_once");
  for (const int rows : {1, 3}) {
    const double end = 0.7 * 2 * pi / omega;
    const Ran ran = run_scene(drawn(rows, 0), "rk4", end / 2000, end);
    const Observation seen = observe(ran.system, end, ran.y);
    const std::string name = ", rows: " + std::to_string(rows);
    const char* reason = "truncation of rk4, (wh)^4/120 of wt = 4.4: 1e-12; a stage's work as its stretch";
    expect("force on them [N]" + name, seen.drive.at(0).x, rows * k * speed / omega * std::sin(omega * end),
           relative(1e-10, reason));
    expect("work put in [J]" + name, seen.energy.plate_work, rows * mass * speed * speed * (1 - std::cos(omega * end)),
           relative(1e-10, reason));
  }
}

TEST(DrivenNodes, RampOfWholePeriodsLeavesNoSwing) {
  requirement("driven.ramp");
  const double ramp = 2 * 2 * pi / omega, end = 1.3 * ramp;
  const Scene scene = drawn(1, ramp);
  double work = 0, way = 0, last_force = 0;  // J, m, N: by the rule of trapezia
  Ran ran = run_scene(scene, "rk4", ramp / 4000, end);
  const Ran half = run_scene(scene, "rk4", ramp / 4000, ramp / 4, [&](double t, const State& y, const JumpReport&) {
    const System system(scene);
    const double force = observe(system, t, y).drive.at(0).x, now = -speed * t * t / (2 * ramp);
    work -= 0.5 * (force + last_force) * (now - way);
    way = now, last_force = force;
    return true;
  });
  const double a = speed / ramp, x = a / (omega * omega) * (1 - std::cos(omega * ramp / 4));
  expect("force in the ramp [N]", observe(half.system, ramp / 4, half.y).drive.at(0).x, k * x,
         relative(1e-9, "truncation of rk4, (wh)^4/120 of the time, and round-off of a stretch of 1e-3 of the place"));
  expect("work: force times way, of the ledger's", work / observe(half.system, ramp / 4, half.y).energy.plate_work, 1,
         absolute(2e-5, "the rule of trapezia, (w h)^2/12 with 1000 steps of a half period: 1e-6; its first step"));
  const Observation after = observe(ran.system, end, ran.y);
  expect("force after it [N]", after.drive.at(0).x, 0, absolute(1e-10, "of 0.4 N in the ramp: truncation of rk4"));
  expect("work put in [J]", after.energy.plate_work, mass * speed * speed / 2, relative(1e-9, "truncation of rk4"));
}

TEST(DrivenNodes, PressAStemAgainstItsHold) {
  requirement("driven.stem");
  constexpr double length = 0.12, press = 1e-5;  // m
  Scene scene = stem::scene_of({3, 1.0 / 3, length});
  Lattice& l = scene.lattice[0];
  l.drive = {{.rows = {40}, .velocity = {0, -press}}};
  const System system(scene);
  const State y = at_rest(system, 1, system.initial_state(), 1e-8);
  const Observation seen = observe(system, 1, y);
  const double force = stem::EA * press / (length - stem::diameter / 2 / 9);
  const char* reason = "the strain, 8e-5: linear statics";
  expect("force on the driven row [N]", seen.drive.at(0).y, force, relative(2e-4, reason));
  expect("energy of the springs: half of force times way [J]", seen.energy.springs, force * press / 2,
         relative(2e-4, reason));
}

}  // namespace
}  // namespace furrow::verification::driven_nodes
