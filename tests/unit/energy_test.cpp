// Balances over a run: momentum to round-off, energy to the order of the method.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run/observe.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// The greatest residual of the energy balance during a run.
double residual(const Scene& scene, const std::string& name, double end, double step) {
  System system(scene);
  State y = system.initial_state();
  const auto method = make_method(name);
  RunPlan plan;
  plan.end = end;
  plan.step = step;
  Energies start;
  double greatest = -1;
  const RunEnd how = run(system, *method, y, plan, [&](double t, const State& now, const JumpReport&) {
    const Energies energy = observe(system, t, now).energy;
    if (greatest < 0) start = energy;
    greatest = std::max(greatest, std::fabs(energy.residual(start)));
    return true;
  });
  EXPECT_EQ(how.ending, Ending::finished) << how.reason;
  return greatest;
}

// A disc falls on a floor. `phase` in [0, 1) sets when in a step it touches, which the residual depends on.
Scene falling(double damping, double friction, double phase) {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.contact.damping_factor = damping;
  scene.contact.friction = friction;
  scene.contact.rolling_friction = friction / 3;
  scene.disc = {disc({0, 0.103 + 0.001 * phase}, 0.1, {friction > 0 ? 1.0 : 0.0, -1}, friction > 0 ? 5 : 0)};
  scene.wall = {wall({0, 0}, {0, 1})};
  return scene;
}

double mean_residual(double damping, double friction, const std::string& method, double step) {
  double sum = 0;
  for (int k = 0; k < 8; ++k) sum += residual(falling(damping, friction, k / 8.0), method, 0.15, step);
  return sum / 8;
}

double observed_order(double damping, double friction, const std::string& method) {
  return std::log2(mean_residual(damping, friction, method, 2e-4) / mean_residual(damping, friction, method, 5e-5)) / 2;
}

// The ledger is integrated by the rule that integrates the velocities. What a step takes from one and does not give to
// the other is h/4 dF dv for the trapezoid: of third order where the force is smooth, and of order 2.5 in the one step
// of a touch, where a damped force grows as overlap^(1/4). Added up over a run: order 2, also with damping and
// friction.
TEST(EnergyResidual, OfAnElasticBounceShrinksWithOrderTwo) {
  EXPECT_NEAR(observed_order(0, 0, "pece"), 2, 0.2);
  EXPECT_NEAR(observed_order(0, 0, "verlet"), 2, 0.2);
}

TEST(EnergyResidual, OfADampedBounceShrinksWithOrderTwo) {
  EXPECT_NEAR(observed_order(0.3, 0, "pece"), 2, 0.2);
  EXPECT_NEAR(observed_order(0.3, 0, "verlet"), 2, 0.2);
}

TEST(EnergyResidual, OfASlidingRollingBounceShrinksWithOrderTwo) {
  EXPECT_NEAR(observed_order(0.3, 0.3, "pece"), 2, 0.25);
}

TEST(EnergyResidual, OfASlidingRollingBounceShrinksWithOrderTwoUnderVerlet) {
  EXPECT_NEAR(observed_order(0.3, 0.3, "verlet"), 2, 0.25);
}

TEST(EnergyResidual, IsSmallAgainstTheEnergyThatIsLost) {
  const double kinetic = 0.5 * 1000 * 3.14159265358979323846 * 0.01 * 2;  // J, more is never there
  EXPECT_LT(mean_residual(0.3, 0.3, "pece", 5e-5), 1e-5 * kinetic);
}

// Discs of all sizes, walls, a moving plate, a lattice that tears: every entry of the ledger is at work. One scene has
// one phase for each of its touches, and they average out less well.
TEST(EnergyResidual, OfABusySceneShrinksWithOrderTwo) {
  const double coarse = residual(busy_scene(), "pece", 0.03, 5e-5);
  const double fine = residual(busy_scene(), "pece", 0.03, 1.25e-5);
  EXPECT_NEAR(std::log2(coarse / fine) / 2, 2, 0.4);
}

TEST(EnergyLedger, EveryEntryIsAtWorkInTheBusyScene) {
  System system(busy_scene());
  State y = system.initial_state();
  const auto method = make_method("pece");
  RunPlan plan;
  plan.end = 0.03;
  run(system, *method, y, plan, [](double, const State&, const JumpReport&) { return true; });
  const Energies e = observe(system, plan.end, y).energy;
  for (const double lost : {e.link_damping, e.contact_viscous, e.friction, e.rolling, e.tear, e.plate_work}) {
    EXPECT_GT(lost, 1e-6);
  }
}

// The link of a border segment tears while a disc presses on the segment: what the contact held is gone and must be
// booked.
TEST(EnergyLedger, BooksTheContactThatATearTakesAway) {
  System system(on_a_segment_that_tears({disc({0.6, 0.09}, 0.1)}));
  State y = system.initial_state();
  const Energies before = observe(system, 0, y).energy;
  ASSERT_EQ(system.jump(0, y).torn.size(), 1u);
  EXPECT_NEAR(observe(system, 0, y).energy.residual(before), 0, 1e-12 * before.contact_elastic);
}

// Found by these two positions: their distance rounds to the sum of the radii, its square to less.
TEST(EnergyLedger, IsFiniteForDiscsThatJustTouch) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.disc = {disc({0, 0}, 0.01), disc({0.020999896369255748, 6.5973331878111446e-05}, 0.011)};
  const System system(scene);
  const State y = system.initial_state();
  for (const double rate : rates(system, 0, y)) EXPECT_TRUE(std::isfinite(rate));
}

// A cluster without walls: discs with friction that collide with each other and with a free lattice.
TEST(Momentum, OfAFreeClusterIsConservedToRoundOff) {
  Scene scene = busy_scene();
  scene.model.gravity = 0;
  scene.wall.clear();
  scene.plate.clear();
  scene.lattice[0].fixed_rows.clear();
  System system(scene);
  State y = system.initial_state();
  const Momentum before = observe(system, 0, y).momentum;
  const auto method = make_method("pece");
  RunPlan plan;
  plan.end = 0.05;
  const RunEnd how = run(system, *method, y, plan, [](double, const State&, const JumpReport&) { return true; });
  EXPECT_EQ(how.ending, Ending::finished) << how.reason;
  const Momentum after = observe(system, plan.end, y).momentum;
  const double size = 40 * 0.05 * 1.0;  // kg m/s: 40 discs of some 0.05 kg at some 1 m/s
  // 500 steps of 58 bodies, each rounded by 1e-16 of its own share: 1e-13 if all of them add up.
  EXPECT_NEAR(after.x, before.x, 1e-13 * size);
  EXPECT_NEAR(after.y, before.y, 1e-13 * size);
}

}  // namespace
}  // namespace furrow
