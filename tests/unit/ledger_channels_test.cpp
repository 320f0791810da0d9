// Each channel of the energy ledger alone, as a power of one contact or link by its closed form, and as what a jump
// enters between two steps.
#include <gtest/gtest.h>

#include <cmath>

#include "ledger_law.h"
#include "run/observe.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;
using namespace test::ledger;

enum class Partner { wall, plate, disc };

// A disc at the origin that moves with v and spin against a partner at rest below it; half as reduced against a disc.
struct Touching {
  Touching(Partner partner, double friction, double rolling, Vec2 v, double spin, double spring = 0)
      : law(partner == Partner::disc ? radius / 2 : radius, partner == Partner::disc ? mass / 2 : mass),
        system(scene(partner, friction, rolling, v, spin)),
        y(system.initial_state()) {
    system.jump(0, y);
    if (friction > 0) {
      slot = find_slot();
      y[system.first_spring() + slot] = spring;
    }
    dydt = rates(system, 0, y);
  }

  static Scene scene(Partner partner, double friction, double rolling, Vec2 v, double spin) {
    Scene s = empty_scene();
    s.contact.damping_factor = 0.1;
    s.contact.friction = friction;
    s.contact.rolling_friction = rolling;
    s.model.rolling_smoothing = 0.5;
    s.disc = {disc({0, 0}, radius, v, spin)};
    if (partner == Partner::wall) s.wall = {wall({0, -radius + overlap}, {0, 1})};
    if (partner == Partner::plate) s.plate = {plate({-5, -1 - radius + overlap}, 10, 1)};
    if (partner == Partner::disc) s.disc.push_back(disc({0, -2 * radius + overlap}, radius));
    return s;
  }

  // The one whose rate is the slip.
  int find_slot() const {
    const State at = rates(system, 0, y);
    for (int k = 0; k < system.spring_count(); ++k) {
      if (at[system.first_spring() + k] != 0) return k;
    }
    return 0;
  }
  double power(Ledger entry) const { return dydt[system.ledger_of(entry)]; }
  double slip() const { return dydt[system.first_spring() + slot]; }

  Law law;
  System system;
  State y, dydt;
  int slot = 0;
};

class EachPartner : public testing::TestWithParam<Partner> {};
INSTANTIATE_TEST_SUITE_P(Ledger, EachPartner, testing::Values(Partner::wall, Partner::plate, Partner::disc),
                         [](const auto& of) {
                           return of.param == Partner::wall ? "wall" : of.param == Partner::plate ? "plate" : "disc";
                         });

TEST_P(EachPartner, NormalDampingTakesItsForceTimesTheSpeed) {
  for (const double speed : {0.3, -0.05}) {
    const Touching t(GetParam(), 0, 0, {0, -speed}, 0);
    ASSERT_GT(t.law.elastic + t.law.viscosity * speed, 0);
    const double want = t.law.viscosity * speed * speed;
    EXPECT_NEAR(t.power(contact_viscous), want, round_off * want);
    for (const Ledger other : {friction_work, rolling_work, stiffening, plate_work, link_damping, tear_energy})
      EXPECT_EQ(t.power(other), 0);
  }
}

// A contact does not pull: one that opens faster than its spring pushes gives all that the spring gives to heat.
TEST_P(EachPartner, AContactThatOpensTooFastTurnsItsSpringIntoHeat) {
  const Touching t(GetParam(), 0, 0, {0, 5}, 0);
  ASSERT_LT(t.law.elastic - t.law.viscosity * 5, 0);
  EXPECT_NEAR(t.power(contact_viscous), t.law.elastic * 5, round_off * t.law.elastic * 5);
}

// vt = vx + w R to the contact: the arm is R - overlap against what is flat, R - overlap/2 against a disc.
TEST_P(EachPartner, StickingIsViscousAndNoFriction) {
  const double arm = radius - (GetParam() == Partner::disc ? 0.5 : 1) * overlap;
  for (const double spring : {0.0, 1e-6, -1e-6}) {
    const Touching t(GetParam(), 100, 0, {0.02, 0}, 0.3, spring);
    const double slip = 0.02 + 0.3 * arm;
    EXPECT_NEAR(std::fabs(t.slip()), slip, round_off);
    const double want = t.law.shear_viscosity * slip * slip;
    EXPECT_NEAR(t.power(contact_viscous), want, round_off * want);
    EXPECT_EQ(t.power(friction_work), 0);
  }
}

// Sliding, Ft = mu Fn against the slip; what its spring takes up meanwhile is stored, not lost.
TEST_P(EachPartner, SlidingIsFrictionAndNotViscous) {
  const double arm = radius - (GetParam() == Partner::disc ? 0.5 : 1) * overlap;
  for (const double sign : {1.0, -1.0}) {
    const double slip = 2 + 0.3 * arm;
    for (const double stored : {0.0, 1e-6}) {
      Touching t(GetParam(), 0.2, 0, {sign * 2, 0}, sign * 0.3, 0);
      const double along = t.slip() > 0 ? 1 : -1;  // the tangent's sense is the law's own
      t = Touching(GetParam(), 0.2, 0, {sign * 2, 0}, sign * 0.3, along * stored);
      const double limit = 0.2 * t.law.elastic;
      ASSERT_GT(t.law.shear_viscosity * slip, limit);
      const double want = limit * slip - t.law.stiffness * stored * slip;
      EXPECT_NEAR(t.power(friction_work), want, round_off * want);
      EXPECT_EQ(t.power(contact_viscous), 0);
    }
  }
}

TEST_P(EachPartner, RollingTakesItsMomentTimesTheSpin) {
  const double reduced = GetParam() == Partner::disc ? radius / 2 : radius;
  for (const double spin : {0.01, -3.0}) {
    const Touching t(GetParam(), 1e-9, 0.05, {}, spin);
    const double moment = 0.05 * reduced * t.law.elastic * spin / std::hypot(spin, 0.5);
    EXPECT_NEAR(t.power(rolling_work), moment * spin, round_off * moment * spin);
  }
}

// d/dt (1/2 St xi^2) at fixed xi, with St ~ sqrt(overlap).
TEST_P(EachPartner, AWoundSpringStiffensWithTheOverlap) {
  for (const double speed : {0.1, -0.05}) {
    const Touching t(GetParam(), 100, 0, {1e-3, -speed}, 0, 1e-4);
    const double want = 0.5 * 1e-8 * t.law.stiffness / (2 * overlap) * speed;
    EXPECT_NEAR(t.power(stiffening), want, round_off * std::fabs(want));
  }
}

TEST(Ledger, PlateWorkIsForceTimesVelocityOfDiscsAndNodes) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.1;
  scene.disc = {disc({-radius + overlap, 0.5}, radius)};
  scene.plate = {plate({0, 0}, 1, 1, {-0.3, 0.2}), plate({2, 0}, 1, 1, {-0.4, 0})};
  Lattice l = lattice({2 + overlap, 0.5}, 1, 1, 1);
  l.contact_radius = radius;
  scene.lattice = {l};
  const System system(scene);
  const State dydt = rates(system, 0, system.initial_state());
  const double on_disc = Law(radius, mass).elastic + Law(radius, mass).viscosity * 0.3;
  const double on_node = Law(radius, 2).elastic + Law(radius, 2).viscosity * 0.4;
  EXPECT_NEAR(dydt[system.ledger_of(plate_work)], on_disc * 0.3 + on_node * 0.4, 1e-7);
  EXPECT_NEAR(dydt[system.ledger_of(contact_viscous)],
              Law(radius, mass).viscosity * 0.09 + Law(radius, 2).viscosity * 0.16, 1e-8);
}

TEST(Ledger, LinkDampingIsAlongTheLinkOrOfTheWholeVelocity) {
  for (const bool axial : {true, false}) {
    Scene scene = empty_scene();
    Lattice l = lattice({0, 0}, 1, 2, 1);
    l.structural = link_kind(10, 7);
    l.damper = axial ? Damper::axial : Damper::full;
    l.node = {node_setting(0, 0, {}, {0.5, 2}), node_setting(0, 1, {}, {-1, 1})};
    scene.lattice = {l};
    const System system(scene);
    const double want = axial ? 7 * 1.5 * 1.5 : 7 * (1.5 * 1.5 + 1);
    EXPECT_NEAR(rates(system, 0, system.initial_state())[system.ledger_of(link_damping)], want, 1e-12);
  }
}

// Found by these two positions: their distance rounds to the sum of the radii, its square to less.
TEST(Ledger, DiscsExactlyAtTouchThatSpinAndPassHaveNoForceAndNoPower) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.contact.rolling_friction = 0.2;
  scene.contact.damping_factor = 0.3;
  scene.disc = {disc({0, 0}, 0.01, {1, 2}, 50),
                disc({0.020999896369255748, 6.5973331878111446e-05}, 0.011, {-1, 0}, -20)};
  System system(scene);
  State y = system.initial_state();
  system.jump(0, y);
  for (int k = 0; k < system.spring_count(); ++k) y[system.first_spring() + k] = 1e-3;
  const State dydt = rates(system, 0, y);
  for (int k = 0; k < ledger_entries; ++k) EXPECT_EQ(dydt[system.ledger_of(static_cast<Ledger>(k))], 0) << k;
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(dydt[system.vx_of(i)], 0);
    EXPECT_EQ(dydt[system.spin_of(i)], 0);
  }
  EXPECT_EQ(observe(system, 0, y).energy.contact_elastic, 0);
}

// The border between two nodes 1.25 m apart has an auxiliary point at 0.125 m; when its link tears it keeps the nodes.
// The disc that lay on that point lies on the first node then, less deep.
TEST(Ledger, ATearBooksItsSpringAndWhatAContactThatStaysHasLost) {
  System system(on_a_segment_that_tears({disc({0.07, 0.06}, 0.1)}));
  State y = system.initial_state();
  const auto held = [](double distance) { return 8.0 / 15 * modulus * std::sqrt(0.1) * std::pow(0.1 - distance, 2.5); };
  const double before = held(std::hypot(0.055, 0.06)), after = held(std::hypot(0.07, 0.06));
  EXPECT_NEAR(observe(system, 0, y).energy.contact_elastic, before, round_off * before);
  y[system.ledger_of(tear_energy)] = 2;
  const JumpReport report = system.jump(7, y);
  ASSERT_EQ(report.torn.size(), 1u);
  EXPECT_EQ(report.torn[0].time, 7);
  EXPECT_NEAR(report.torn[0].force, 4 * 0.25, round_off);
  EXPECT_NEAR(observe(system, 0, y).energy.contact_elastic, after, round_off * after);
  const double want = 0.5 * 4 * 0.25 * 0.25 + before - after;
  EXPECT_NEAR(y[system.ledger_of(tear_energy)] - 2, want, round_off * before);
}

}  // namespace
}  // namespace furrow
