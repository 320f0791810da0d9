// The watch over a run: what it sees, when it warns, and when it ends the run.
#include "run/validity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "physics/impact.h"
#include "run/stiffness.h"
#include "watched_run.h"

namespace furrow {
namespace {

using namespace test;

// A disc in the material of scenes.h: E* = 533333.3 Pa with its like, R = 0.1 m, m = 31.4 kg.
constexpr double modulus = 1e6 / (2 * (1 - 0.0625)), radius = 0.1;
const double mass = 1000 * std::numbers::pi * radius * radius;

// J: the integral of 4/3 E* sqrt(R*) d^(3/2).
double work(double reduced_radius, double overlap) {
  return 8.0 / 15.0 * modulus * std::sqrt(reduced_radius) * std::pow(overlap, 2.5);
}

Scene two_discs(double closing) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, radius, {closing / 2, 0}), disc({2 * radius, 0}, radius, {-closing / 2, 0})};
  return scene;
}

Scene disc_and_plate(double speed, double width) {
  Scene scene = empty_scene();
  scene.disc = {disc({-radius, 0}, radius, {speed, 0})};
  scene.plate = {plate({0, -1}, width, 2)};
  return scene;
}

Scene disc_and_lattice(double speed, int auxiliary) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, -0.5}, 11, 3, 0.1);
  l.fixed_columns = {0, 1, 2};
  l.auxiliary_points = auxiliary;
  scene.disc = {disc({-radius, 0.013}, radius, {speed, 0})};
  scene.lattice = {l};
  return scene;
}

TEST(Validity, AnElasticBounceKeepsToEverything) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, radius}, radius, {0, -0.05})};
  scene.wall = {wall({0, 0}, {0, 1})};
  const WatchedRun r = watched(scene, "verlet", 1e-4, 0.3);
  EXPECT_EQ(r.end.ending, Ending::finished);
  EXPECT_TRUE(r.warnings.empty()) << r.warnings.front();
  for (const Watched& w : r.watch) EXPECT_EQ(w.verdict(), Verdict::kept) << w.name << " " << w.worst;
}

TEST(Validity, GreatestOverlapIsOfAllStepsNotOfRows) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, radius}, radius, {0, -0.05})};
  scene.wall = {wall({0, 0}, {0, 1})};
  const double deepest = std::pow(0.5 * mass * 0.05 * 0.05 / work(radius, 1), 0.4);
  const WatchedRun r = watched(scene, "verlet", 1e-5, 0.3);
  // Verlet at 3000 steps a contact: 1e-7; a sample between two steps misses the top by less.
  EXPECT_NEAR(r.of(WatchKind::overlap).worst, deepest / radius, 1e-6 * deepest / radius);
  EXPECT_EQ(r.of(WatchKind::overlap).where, "disc 0 and wall 0");
}

TEST(Validity, LargestForceOnAPlateIsOfAllSteps) {
  const double speed = 0.05;
  const double deepest = std::pow(0.5 * mass * speed * speed / work(radius, 1), 0.4);
  const WatchedRun r = watched(disc_and_plate(speed, 0.05), "verlet", 1e-5, 0.3);
  ASSERT_EQ(r.extremes.plate.size(), 1U);
  const double force = 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(deepest, 1.5);
  EXPECT_NEAR(r.extremes.plate[0].fx, force, 1e-6 * force);
  EXPECT_NEAR(r.extremes.speed, speed, 1e-6 * speed);
}

TEST(Validity, AStepTooLongForAnImpactMakesEnergyAndEndsTheRun) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, radius}, radius, {0, -0.5})};
  scene.wall = {wall({0, 0}, {0, 1})};
  const WatchedRun r = watched(scene, "rk4", 0.1, 1);  // the contact lasts 0.106 s
  EXPECT_NE(r.end.ending, Ending::finished);
  EXPECT_EQ(r.of(WatchKind::energy_made).verdict(), Verdict::broken);
  EXPECT_EQ(r.of(WatchKind::arrival).verdict(), Verdict::warned) << "it arrives too fast for that step";
  ASSERT_FALSE(r.warnings.empty());
  EXPECT_NE(r.warnings[0].find("at t = 0 s the step is"), std::string::npos) << "which is known before it touches";
}

TEST(Validity, TheArrivalIsJudgedByTheStiffnessOfTheImpact) {
  const Scene scene = two_discs(0.2);
  const System system(scene);
  const double deepest = std::pow(0.5 * (mass / 2) * 0.04 / work(radius / 2, 1), 0.4);
  const Oscillator o = stiffest_impact(system.parts(), 0.2);
  EXPECT_NEAR(o.omega, std::sqrt(2 * modulus * std::sqrt(radius / 2 * deepest) / (mass / 2)), 1e-9 * o.omega);
  EXPECT_EQ(o.zeta, 0);
}

TEST(Validity, WithoutALedgerTheEnergyIsNotWatched) {
  Scene scene = two_discs(0.1);
  scene.output.energy = false;
  const WatchedRun r = watched(scene, "verlet", 1e-4, 0.1);
  EXPECT_EQ(r.of(WatchKind::energy_made).verdict(), Verdict::not_watched);
  EXPECT_EQ(r.of(WatchKind::energy_lost).verdict(), Verdict::not_watched);
}

// The work of the elastic force up to where centres pass decides; each pair just slower and just faster than that.
TEST(Validity, TwoDiscsPassEachOtherFromTheSpeedOfTheWorkOn) {
  const double speed = std::sqrt(2 * work(radius / 2, 2 * radius) / (mass / 2));
  const WatchedRun slower = watched(allowing_all(two_discs(0.999 * speed)), "verlet", 1e-5, 0.15);
  EXPECT_LT(slower.of(WatchKind::impact).worst, 1);
  EXPECT_GT(slower.of(WatchKind::impact).worst, 0.99);
  EXPECT_GT(slower.y[1], slower.y[0]) << "they came back";
  const WatchedRun faster = watched(allowing_all(two_discs(1.001 * speed)), "verlet", 1e-5, 0.15);
  EXPECT_GT(faster.of(WatchKind::impact).worst, 1);
  EXPECT_GT(faster.of(WatchKind::overlap).worst, 1.9) << "of a radius: two radii where the centres pass";
  EXPECT_LT(faster.y[1], faster.y[0]) << "they have passed";
  EXPECT_EQ(faster.of(WatchKind::impact).where, "disc 0 and disc 1");
}

TEST(Validity, ADiscPassesAPlateFromTheSpeedOfTheWorkOn) {
  const double width = 0.05;
  const double speed = std::sqrt(2 * work(radius, radius + width / 2) / mass);
  const WatchedRun slower = watched(allowing_all(disc_and_plate(0.999 * speed, width)), "verlet", 1e-5, 0.3);
  EXPECT_EQ(slower.of(WatchKind::through_plates).worst, 0);
  EXPECT_LT(slower.of(WatchKind::impact).worst, 1);
  const WatchedRun faster = watched(allowing_all(disc_and_plate(1.001 * speed, width)), "verlet", 1e-5, 0.3);
  EXPECT_EQ(faster.of(WatchKind::through_plates).worst, 1);
  EXPECT_EQ(faster.of(WatchKind::through_plates).where, "disc 0 and plate 0");
  EXPECT_GT(faster.of(WatchKind::impact).worst, 1);
}

// With this damping a head-on impact is a linear oscillator in d^(5/4); below critical damping and far above.
TEST(Validity, DampingRaisesTheSpeedByTheLinearOscillatorsFactor) {
  for (const double beta : {0.3, 1.0, 3.0}) {
    Scene scene = disc_and_plate(1, 0.05);
    scene.contact.damping_factor = beta;
    const System system(scene);
    const double factor = impact_factor(system.parts().law[0]);
    // The peak of the oscillator by its own equation: z'' + 2 beta z' + z = 0, z(0) = 0, z'(0) = 1.
    double z = 0, v = 1, peak = 0;
    constexpr double h = 1e-5;
    while (v > 0) {
      const double vm = v + 0.5 * h * (-2 * beta * v - z), zm = z + 0.5 * h * v;
      z += h * vm;
      v += h * (-2 * beta * vm - zm);
      peak = std::max(peak, z);
    }
    EXPECT_NEAR(factor, peak, 1e-8) << beta;  // midpoint rule, h^2
    const double speed = std::sqrt(2 * work(radius, radius + 0.025) / mass) / factor;
    scene.disc[0].velocity.x = 0.99 * speed;
    EXPECT_EQ(watched(allowing_all(scene), "rk4", 1e-6, 0.06).of(WatchKind::through_plates).worst, 0) << beta;
    scene.disc[0].velocity.x = 1.01 * speed;
    EXPECT_EQ(watched(allowing_all(scene), "rk4", 1e-6, 0.06).of(WatchKind::through_plates).worst, 1) << beta;
  }
}

TEST(Validity, ADiscPassesABorderFromTheSpeedOfTheWorkOn) {
  const double speed = std::sqrt(2 * work(radius, radius) / mass);
  for (const int auxiliary : {0, 9}) {
    // Between two of the 9 points a centre passes 5 mm from either: 0.95 of the overlap, 0.94 of the speed.
    const WatchedRun slower = watched(allowing_all(disc_and_lattice(0.93 * speed, auxiliary)), "verlet", 1e-5, 0.1);
    EXPECT_EQ(slower.of(WatchKind::through_lattices).worst, 0) << auxiliary;
    const WatchedRun faster = watched(allowing_all(disc_and_lattice(1.03 * speed, auxiliary)), "verlet", 1e-5, 0.1);
    EXPECT_GE(faster.of(WatchKind::through_lattices).worst, 1) << auxiliary;
  }
}

TEST(Validity, WhatCrossesEndsTheRunUnlessTheSceneAllowsIt) {
  const double speed = 1.01 * std::sqrt(2 * work(radius, radius + 0.025) / mass);
  Scene scene = disc_and_plate(speed, 0.05);
  scene.allow = Allow{};
  scene.allow->overlap = 2;
  const WatchedRun ends = watched(scene, "verlet", 1e-5, 0.3);
  EXPECT_EQ(ends.end.ending, Ending::invalid);
  EXPECT_NE(ends.end.reason.find("[allow] through_plates"), std::string::npos) << ends.end.reason;
  EXPECT_EQ(ends.end.time, ends.of(WatchKind::through_plates).time);
  scene.allow->through_plates = true;
  const WatchedRun goes_on = watched(scene, "verlet", 1e-5, 0.3);
  EXPECT_EQ(goes_on.end.ending, Ending::finished);
  EXPECT_EQ(goes_on.of(WatchKind::through_plates).verdict(), Verdict::allowed);
}

TEST(Validity, ABodyStillBeyondWhatIsAllowedEndsTheRun) {
  Scene scene = two_discs(3);
  scene.allow = Allow{};
  scene.allow->overlap = 0.3;
  const WatchedRun r = watched(scene, "verlet", 1e-5, 0.3);
  EXPECT_EQ(r.end.ending, Ending::finished) << "beyond 0.3, but not beyond 1, which ends a run";
  EXPECT_EQ(r.of(WatchKind::overlap).verdict(), Verdict::warned);
}

TEST(Validity, CentresBehindAWallAreCounted) {
  Scene scene = empty_scene();
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.disc = {disc({0, -0.01}, radius), disc({1, -0.02}, radius), disc({2, 0.01}, radius)};
  const WatchedRun ends = watched(scene, "verlet", 1e-5, 1e-4);
  EXPECT_EQ(ends.end.ending, Ending::invalid);
  const WatchedRun r = watched(allowing_all(scene), "verlet", 1e-5, 1e-4);
  EXPECT_EQ(r.of(WatchKind::behind_walls).worst, 2);
}

TEST(Validity, APlateThatStepsOverABodyEndsTheRun) {
  Scene scene = empty_scene();
  scene.disc = {disc({0.023, 0}, 1e-3)};
  scene.plate = {plate({0, -0.1}, 5e-4, 0.2, {5, 0})};
  const WatchedRun r = watched(scene, "pece", 1e-3, 0.01);
  EXPECT_EQ(r.end.ending, Ending::diverged);
  EXPECT_NE(r.end.reason.find("disc 0 and plate 0 met within one step"), std::string::npos) << r.end.reason;
  scene.disc[0].position.y = 0.3;  // out of its way
  EXPECT_EQ(watched(scene, "pece", 1e-3, 0.01).end.ending, Ending::finished);
}

// Plates, walls and lattices, but nothing that moves by forces.
TEST(Validity, ASceneWithoutMovingBodiesRuns) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 2, 3, 0.05);
  l.fixed_rows = {0, 1};
  scene.lattice = {l};
  for (const bool driven : {false, true}) {
    if (driven) scene.lattice[0].fixed_rows = {0}, scene.lattice[0].drive = {{.rows = {1}, .velocity = {0.1, 0}}};
    for (const int plates : {0, 1, 2}) {
      scene.plate.assign(static_cast<std::size_t>(plates), plate({0.3, 0}, 0.01, 0.2, {0.1, 0}));
      for (const char* method : {"pece", "rk4", "odeint_dopri5", "rkc"}) {
        const WatchedRun r = watched(scene, method, 1e-3, 0.02);
        EXPECT_EQ(r.end.ending, Ending::finished) << method << " " << plates << " " << r.end.reason;
      }
    }
  }
}

TEST(Validity, AFastNodeDoesNotStepThroughAThinPlate) {
  Scene scene = empty_scene();
  Lattice l = lattice({-0.02, 0}, 1, 1, 0.05);
  l.node = {node_setting(0, 0, {}, {4, 0})};
  scene.lattice = {l};
  scene.plate = {plate({0, -0.1}, 5e-4, 0.2)};
  const WatchedRun r = watched(scene, "pece", 1e-2, 0.05);
  EXPECT_EQ(r.end.ending, Ending::diverged);
  EXPECT_NE(r.end.reason.find("stepped over node"), std::string::npos) << r.end.reason;
}

TEST(Validity, StepsThatLeadNowhereAreADivergence) {
  Scene scene = two_discs(0.1);
  scene.contact.friction = 0.5;
  scene.contact.damping_factor = 0.5;
  scene.time.relative_tolerance = 1e-17;
  scene.time.absolute_tolerance = 1e-30;
  const WatchedRun r = watched(scene, "rkc", 1e-3, 1);
  EXPECT_EQ(r.end.ending, Ending::diverged);
}

TEST(Validity, TheWatchMovesNoBit) {
  Scene scene = two_discs(1);
  scene.contact.damping_factor = 0.2;
  for (const char* method : {"pece", "pec", "verlet", "rk4", "odeint_abm3", "rkc", "symplectic_euler"}) {
    const WatchedRun r = watched(scene, method, 1e-4, 0.05);
    System system(scene);
    State y = system.initial_state();
    RunPlan plan;
    plan.end = 0.05;
    plan.step = 1e-4;
    const auto made = make_method(method, {scene.time.relative_tolerance, scene.time.absolute_tolerance, 1e-4});
    run(system, *made, y, plan, [](double, const State&, const JumpReport&) { return true; });
    EXPECT_EQ(r.y, y) << method;
  }
}

TEST(Spin, IsKeptWhereNothingTurnsADisc) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, radius, {}, 10)};
  const System system(scene);
  const Observation seen = observe(system, 0, system.initial_state());
  const double inertia = mass * radius * radius / 2;
  EXPECT_NEAR(seen.energy.kinetic, 0.5 * inertia * 100, 1e-12);
  EXPECT_NEAR(seen.momentum.angular, inertia * 10, 1e-13);
}

// Ghrist, Fornberg and Reeger 2012: the pair AB3-AM3 has no stable interval from zero on the imaginary axis.
TEST(StepAdvice, ARegionThatBeginsUnstableHasNoLargestStableStep) {
  const double limit = largest_stable_step("odeint_abm3", {1, 0});
  EXPECT_LT(limit, 0.2);
  EXPECT_NEAR(largest_stable_step("pece", {1, 0}), 1.287, 0.002);
  EXPECT_NEAR(largest_stable_step("ab2", {1, 0}), std::pow(4e-5, 0.25), 0.01);
}

}  // namespace
}  // namespace furrow
