// When the watch over the energy looks, and what it lets pass.
#include <gtest/gtest.h>

#include <tuple>

#include "methods/stability.h"
#include "watched_run.h"

namespace furrow {
namespace {

using namespace test;

// Two nodes of 2 kg on a spring, omega = 10 rad/s: at 1.01 times its limit rk4 makes a seventh of the energy a step.
TEST(EnergyWatch, ARunOfFewStepsEndsWhereItHasMadeItsEnergy) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 1, 2, 0.1);
  l.structural = link_kind(100, 0);
  l.node = {node_setting(0, 0, {}, {1e-3, 0}), node_setting(0, 1, {}, {-1e-3, 0})};
  scene.lattice = {l};
  const double step = 1.01 * largest_stable_step("rk4", {10, 0});
  const WatchedRun r = watched(scene, "rk4", step, 150 * step);
  EXPECT_EQ(r.end.ending, Ending::invalid) << r.end.reason;
  EXPECT_LE(r.end.steps, 2) << "a seventh is more than a tenth";
}

// A disc of 0.01 m that comes to a wall in steps of a tenth of the contact: what verlet is off in the middle of the contact is
// gone after it. The greatest residual over the steps, found here at each.
TEST(EnergyWatch, OfAFewBodiesTheWorstOfAllStepsIsSeen) {
  Scene scene = empty_scene();
  scene.material[0].young = 8e9;
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.disc = {disc({0, 0.0105}, 0.01, {0, -1})};
  scene = allowing_all(scene);
  constexpr double step = 2e-4;
  System system(scene);
  State y = system.initial_state();
  const auto method = make_method("verlet", {});
  const Energies start = observe(system, 0, y).energy;
  double worst = 0;
  RunPlan plan{.start = 0, .end = 60 * step, .step = step, .stop = {}};
  run(system, *method, y, plan, [&](double t, const State& now, const JumpReport&) {
    worst = std::max(worst, observe(system, t, now).energy.residual(start) / start.live());
    return true;
  });
  const double at_end = observe(system, plan.end, y).energy.residual(start) / start.live();
  ASSERT_GT(worst, 0.1) << "or nothing was tried";
  ASSERT_LT(std::fabs(at_end), 0.5 * worst);
  EXPECT_NEAR(watched(scene, "verlet", step, plan.end).of(WatchKind::energy_made).worst, worst, 1e-12);
  scene.allow = {};
  EXPECT_EQ(watched(scene, "verlet", step, plan.end).end.ending, Ending::invalid);
}

// Of what falls, the first step of semi-implicit Euler has twice the energy, the n-th (1 + 1/n).
TEST(EnergyWatch, ThatAFirstOrderMethodBeginsRoughlyIsNoWarning) {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.disc = {disc({0, 0}, 0.1)};
  const WatchedRun r = watched(scene, "symplectic_euler", 1e-3, 0.199);
  EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  EXPECT_EQ(r.warnings, std::vector<std::string>{});
}

// What the spring holds after slip may be more than the limit if the damper pushes the other way: it makes energy that
// is booked as stiffening and as negative heat.
Scene overfull_spring(ForceLaw law, double friction) {
  Scene scene = empty_scene();
  scene.material[0].young = 2e7;
  scene.model.law = law;
  scene.model.after_slip = AfterSlip::less_viscous;
  scene.contact.friction = friction;
  scene.contact.damping_factor = 2;
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.disc = {disc({0, 0.01}, 0.01, {0.107, -0.169}, 10)};
  return scene;
}

TEST(EnergyWatch, EnergyThatALawMakesIsNoticed) {
  for (const ForceLaw law : {ForceLaw::hertz_mindlin, ForceLaw::rescaled_mindlin}) {
    for (const double friction : {0.1, 0.3, 0.5}) {
      const WatchedRun r = watched(allowing_all(overfull_spring(law, friction)), "pece", 5e-6, 0.025);
      ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
      EXPECT_GT(r.of(WatchKind::energy_made).worst, 1) << "there is many times what there was at the start";
    }
  }
}

// Two discs that have nothing to do with it, and dissipate more than the first one takes back.
TEST(EnergyWatch, HeatElsewhereHidesNone) {
  Scene scene = overfull_spring(ForceLaw::hertz_mindlin, 0.5);
  scene.disc.push_back(disc({1, 0.5}, 0.01, {0.6, 0}));
  scene.disc.push_back(disc({1.0200001, 0.5}, 0.01, {-0.6, 0}));
  EXPECT_GT(watched(allowing_all(scene), "pece", 5e-6, 0.004).of(WatchKind::energy_made).worst, 0.1);
}

TEST(EnergyWatch, AnObliqueImpactWithoutItMakesNone) {
  for (const ForceLaw law : {ForceLaw::hertz_mindlin, ForceLaw::rescaled_mindlin}) {
    Scene scene = overfull_spring(law, 0.5);
    scene.model.after_slip = AfterSlip::elastic;
    for (const double damping : {0.0, 0.3}) {
      scene.contact.damping_factor = damping;
      const WatchedRun r = watched(scene, "pece", 5e-6, 0.025);
      EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
      EXPECT_LT(r.of(WatchKind::energy_made).worst, 0.01) << damping;
    }
  }
}

// A ball that a coarse step throws back too fast or too slowly. What flies beside it and meets nothing, however heavy and
// fast, is no measure of that.
TEST(EnergyWatch, WhatMeetsNothingHidesNothing) {
  for (const auto& [method, step] : {std::pair{"odeint_abm1", 2.4e-4}, {"rk4", 1e-3}}) {
    Scene scene = empty_scene();
    scene.material[0].young = 1e9;
    scene.wall = {wall({0, 0}, {0, 1})};
    scene.disc = {disc({0, 0.0101}, 0.01, {0, -0.2})};
    const WatchedRun alone = watched(allowing_all(scene), method, step, 0.05);
    scene.disc.push_back(disc({50, 50}, 3, {0.5, 1}));
    const WatchedRun beside = watched(allowing_all(scene), method, step, 0.05);
    double worst = 0;
    for (const WatchKind kind : {WatchKind::energy_made, WatchKind::energy_lost}) {
      EXPECT_NEAR(beside.of(kind).worst, alone.of(kind).worst, 1e-6 * alone.of(kind).worst) << method;
      worst = std::max(worst, alone.of(kind).worst);
    }
    EXPECT_GT(worst, 0.1) << method << ": or nothing was tried";
  }
}

// A method of first order does not keep the energy of a fall. Wherever the origin is, that is no fault of the scene, and a heavy
// disc that falls so beside a light one at rest is none.
TEST(EnergyWatch, AFallByAFirstOrderMethodIsSoundFromAnyHeight) {
  for (const auto& [height, step, end] :
       {std::tuple{1.0, 1e-6, 0.01}, {100.0, 1e-6, 0.01}, {1000.0, 1e-5, 0.02}, {-500.0, 1e-5, 0.02}}) {
    Scene scene = empty_scene();
    scene.model.gravity = 9.81;
    scene.disc = {disc({0, height}, 0.01)};
    const WatchedRun r = watched(scene, "symplectic_euler", step, end);
    EXPECT_EQ(r.end.ending, Ending::finished) << height << ": " << r.end.reason;
    EXPECT_TRUE(r.warnings.empty()) << height << ": " << r.warnings[0];
  }
}

// What has just touched is not idle, though it has lost next to nothing of what it has: a disc that spins fast is set down,
// a heavy one meets a grain. The ledger closes, at any step; so there is nothing to say.
TEST(EnergyWatch, WhatHasJustTouchedIsNotIdle) {
  Scene set_down = empty_scene();
  set_down.material[0].young = 1e7;
  set_down.wall = {wall({0, 0}, {0, 1})};
  Scene grain = set_down;
  grain.wall.clear();
  grain.disc = {disc({0, 0.05005}, 0.05, {0, -0.01}), disc({0, -0.001}, 0.001)};
  for (const double step : {1e-5, 1e-6}) {
    for (const double spin : {5.0, 100.0, 1000.0}) {
      for (const double friction : {0.0, 0.3}) {
        set_down.disc = {disc({0, 0.05001}, 0.05, {0, -0.01}, spin)};
        set_down.contact.friction = friction;
        const WatchedRun r = watched(set_down, "verlet", step, 0.004);
        EXPECT_EQ(r.end.ending, Ending::finished) << spin << " rad/s: " << r.end.reason;
        EXPECT_EQ(r.warnings, std::vector<std::string>{});
      }
    }
    const WatchedRun r = watched(grain, "verlet", step, 0.02);
    EXPECT_EQ(r.end.ending, Ending::finished) << r.end.reason;
    EXPECT_EQ(r.warnings, std::vector<std::string>{});
  }
}

TEST(EnergyWatch, AdvisesAnotherLawWhereTheLawMakesIt) {
  const WatchedRun by_law = watched(overfull_spring(ForceLaw::hertz_mindlin, 0.5), "pece", 5e-6, 0.025);
  EXPECT_EQ(by_law.end.ending, Ending::invalid);
  EXPECT_NE(by_law.end.reason.find("take model.after_slip = \"elastic\""), std::string::npos) << by_law.end.reason;
}

}  // namespace
}  // namespace furrow
