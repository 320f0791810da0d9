// Forces on discs and nodes, worked out by hand for each kind of contact.
#include <gtest/gtest.h>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// E = 1e6 Pa, nu = 1/4 twice.
constexpr double modulus = 1e6 / 1.875;  // Pa, E*
constexpr double round_off = 1e-12;      // relative: an overlap is a small difference of larger numbers

double hertz(double reduced_radius, double overlap) {
  return 4.0 / 3 * modulus * std::sqrt(reduced_radius) * overlap * std::sqrt(overlap);
}

TEST(DiscOnDisc, PushesBothByHertz) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.3), disc({0.3, 0.4}, 0.21)};  // 0.5 m apart: 0.01 m of overlap
  const System system(scene);
  const State dydt = rates(system, 0, system.initial_state());
  const double want = hertz(0.3 * 0.21 / 0.51, 0.01);
  const Vec2 on_first = force_on(system, dydt, 0);
  const Vec2 on_second = force_on(system, dydt, 1);
  EXPECT_NEAR(on_first.x, -0.6 * want, round_off * want);
  EXPECT_NEAR(on_first.y, -0.8 * want, round_off * want);
  EXPECT_NEAR(on_second.x, 0.6 * want, round_off * want);
  EXPECT_NEAR(on_second.y, 0.8 * want, round_off * want);
}

TEST(DiscOnDisc, ContactBeginsAtTouch) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.25), disc({0.5, 0}, 0.25)};
  const System touching(scene);
  EXPECT_EQ(rates(touching, 0, touching.initial_state())[touching.vx_of(0)], 0);
  scene.disc[1].position.x = std::nextafter(0.5, 0);
  const System overlapping(scene);
  EXPECT_LT(rates(overlapping, 0, overlapping.initial_state())[overlapping.vx_of(0)], 0);
}

TEST(DiscOnWall, HasTheDiscsRadiusAndMass) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.1;
  scene.disc = {disc({5, 0.29}, 0.3, {0, -0.2})};
  scene.wall = {wall({0, 0}, {0, 2})};
  const System system(scene);
  const State dydt = rates(system, 0, system.initial_state());
  const double mass = 1000 * 3.14159265358979323846 * 0.09;
  const double stiffness = 2 * modulus * std::sqrt(0.3 * 0.01);
  const double want = hertz(0.3, 0.01) + 2 * std::sqrt(5.0 / 6) * 0.1 * std::sqrt(stiffness * mass) * 0.2;
  EXPECT_NEAR(mass * dydt[system.vy_of(0)], want, round_off * 10 * want);
  EXPECT_EQ(dydt[system.vx_of(0)], 0);
}

TEST(DiscOnPlate, MovesWithThePlate) {
  Scene scene = empty_scene();
  scene.disc = {disc({1.29, 0.5}, 0.3)};
  scene.plate = {plate({-0.5, 0}, 1, 1, {0.5, 0})};  // its right face is at 1 m at t = 1 s
  const System system(scene);
  const State y = system.initial_state();
  EXPECT_EQ(rates(system, 0, y)[system.vx_of(0)], 0);
  const double want = hertz(0.3, 0.01);
  EXPECT_NEAR(force_on(system, rates(system, 1, y), 0).x, want, round_off * 10 * want);
}

TEST(DiscOnPlate, CornerPushesAlongTheDiagonal) {
  Scene scene = empty_scene();
  scene.disc = {disc({1.174, 1.232}, 0.3)};  // (0.6, 0.8) times 0.29 m off the corner (1, 1)
  scene.plate = {plate({0, 0}, 1, 1)};
  const System system(scene);
  const Vec2 force = force_on(system, rates(system, 0, system.initial_state()), 0);
  const double want = hertz(0.3, 0.01);
  EXPECT_NEAR(force.x, 0.6 * want, round_off * 10 * want);
  EXPECT_NEAR(force.y, 0.8 * want, round_off * 10 * want);
}

TEST(DiscOnPlate, ViscousForceFollowsTheRelativeVelocity) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.1;
  scene.disc = {disc({1.29, 0.5}, 0.3, {0.5, 0})};
  scene.plate = {plate({0, 0}, 1, 1, {0.5, 0})};
  const System system(scene);
  const double want = hertz(0.3, 0.01);  // both move alike
  EXPECT_NEAR(force_on(system, rates(system, 0, system.initial_state()), 0).x, want, round_off * 10 * want);
}

TEST(DiscOnLattice, ForceIsSharedByNearnessAndMassIsReducedAccordingly) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.1;
  scene.disc = {disc({0.3, 0.19}, 0.2, {0, -0.4})};  // above the point 0.3 of a segment of 1 m
  scene.lattice = {lattice({0, 0}, 1, 2, 1)};        // 2 kg a node, no links
  const System system(scene);
  const State dydt = rates(system, 0, system.initial_state());
  const double mass = 1000 * 3.14159265358979323846 * 0.04;
  const double reduced_mass = 1 / (1 / mass + (0.49 + 0.09) / 2);
  const double stiffness = 2 * modulus * std::sqrt(0.2 * 0.01);
  const double want = hertz(0.2, 0.01) + 2 * std::sqrt(5.0 / 6) * 0.1 * std::sqrt(stiffness * reduced_mass) * 0.4;
  EXPECT_NEAR(force_on(system, dydt, 0).y, want, 10 * round_off * want);
  EXPECT_NEAR(force_on(system, dydt, 1).y, -0.7 * want, 10 * round_off * want);
  EXPECT_NEAR(force_on(system, dydt, 2).y, -0.3 * want, 10 * round_off * want);
}

TEST(DiscOnLattice, FixedNodesCountAsInfinitelyHeavy) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.1;
  scene.disc = {disc({0.3, 0.19}, 0.2, {0, -0.4})};
  scene.lattice = {lattice({0, 0}, 1, 2, 1)};
  scene.lattice[0].fixed_columns = {0};
  const System system(scene);
  const double mass = 1000 * 3.14159265358979323846 * 0.04;
  const double reduced_mass = 1 / (1 / mass + 0.09 / 2);
  const double stiffness = 2 * modulus * std::sqrt(0.2 * 0.01);
  const double want = hertz(0.2, 0.01) + 2 * std::sqrt(5.0 / 6) * 0.1 * std::sqrt(stiffness * reduced_mass) * 0.4;
  EXPECT_NEAR(force_on(system, rates(system, 0, system.initial_state()), 0).y, want, 10 * round_off * want);
}

TEST(DiscOnLattice, ApproachIsThatOfTheSharedPoint) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.1;
  scene.disc = {disc({0.3, 0.19}, 0.2, {0, -0.4})};
  scene.lattice = {lattice({0, 0}, 1, 2, 1)};
  scene.lattice[0].node = {node_setting(0, 0, {}, {0, -0.1}), node_setting(0, 1, {}, {0, -1.1})};  // 0.7 0.1 + 0.3 1.1
  const System system(scene);
  const double want = hertz(0.2, 0.01);
  EXPECT_NEAR(force_on(system, rates(system, 0, system.initial_state()), 0).y, want, 10 * round_off * want);
}

TEST(DiscOnLattice, AuxiliaryPointsTakeTheNearestTenth) {
  Scene scene = empty_scene();
  scene.disc = {disc({0.33, 0.16}, 0.2)};  // 0.03 m beside the point 0.3: 0.1627... m from it
  scene.lattice = {lattice({0, 0}, 1, 2, 1)};
  const System coarse(scene);
  const double distance = std::hypot(0.03, 0.16);
  const double want = hertz(0.2, 0.2 - distance);
  const Vec2 force = force_on(coarse, rates(coarse, 0, coarse.initial_state()), 0);
  EXPECT_NEAR(force.x, want * 0.03 / distance, 10 * round_off * want);
  EXPECT_NEAR(force.y, want * 0.16 / distance, 10 * round_off * want);
  scene.lattice[0].auxiliary_points = 0;
  const System exact(scene);
  const Vec2 upright = force_on(exact, rates(exact, 0, exact.initial_state()), 0);
  EXPECT_NEAR(upright.x, 0, 10 * round_off * want);
  EXPECT_NEAR(upright.y, hertz(0.2, 0.04), 10 * round_off * want);
}

TEST(NodeOnPlate, IsPushedOutThroughTheNearestFace) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.1;
  scene.plate = {plate({0, 0}, 1, 3, {0.25, 0})};
  Lattice l = lattice({0.9375, 1.5}, 1, 1, 1);
  l.contact_radius = 0.04;
  scene.lattice = {l};
  const System system(scene);
  const double stiffness = 2 * modulus * std::sqrt(0.04 * 0.0625);  // approach 0.25 m/s, node of 2 kg
  const double want = hertz(0.04, 0.0625) + 2 * std::sqrt(5.0 / 6) * 0.1 * std::sqrt(stiffness * 2) * 0.25;
  const Vec2 force = force_on(system, rates(system, 0, system.initial_state()), 0);
  EXPECT_NEAR(force.x, want, 10 * round_off * want);
  EXPECT_EQ(force.y, 0);
}

TEST(NodeOnPlate, DoesNothingOutside) {
  Scene scene = empty_scene();
  scene.plate = {plate({0, 0}, 1, 3)};
  scene.lattice = {lattice({1.001, 1.5}, 1, 1, 1)};  // nearer than its contact radius, but not inside
  const System system(scene);
  EXPECT_EQ(rates(system, 0, system.initial_state())[system.vx_of(0)], 0);
}

TEST(NodeOnWall, IsPushedBackToItsSide) {
  Scene scene = empty_scene();
  scene.wall = {wall({0, 0}, {0, 1})};
  Lattice l = lattice({3, -0.01}, 1, 1, 1);
  l.contact_radius = 0.04;
  scene.lattice = {l};
  const System system(scene);
  const double want = hertz(0.04, 0.01);
  EXPECT_NEAR(force_on(system, rates(system, 0, system.initial_state()), 0).y, want, round_off * want);
}

TEST(SeveralLatticesAndPlates, EachActsOnItsOwn) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0.19}, 0.2), disc({10, 0.18}, 0.2)};
  scene.lattice = {lattice({-0.5, 0}, 1, 2, 1), lattice({9.5, 0}, 1, 2, 1)};
  scene.plate = {plate({-1, -5}, 0.51, 10), plate({10.48, -5}, 1, 10)};  // node 0 is 0.01 m deep, node 3 0.02 m
  const System system(scene);
  const State dydt = rates(system, 0, system.initial_state());
  const auto force = [&](int body) { return force_on(system, dydt, body); };
  const double first = hertz(0.2, 0.01);
  const double second = hertz(0.2, 0.02);
  EXPECT_NEAR(force(0).y, first, 10 * round_off * first);
  EXPECT_NEAR(force(1).y, second, 10 * round_off * second);
  for (const int node : {2, 3}) EXPECT_NEAR(force(node).y, -0.5 * first, 10 * round_off * first);
  for (const int node : {4, 5}) EXPECT_NEAR(force(node).y, -0.5 * second, 10 * round_off * second);
  const double node_radius = 0.01;
  EXPECT_NEAR(force(2).x, hertz(node_radius, 0.01), 100 * round_off * first);
  EXPECT_EQ(force(3).x, 0);
  EXPECT_EQ(force(4).x, 0);
  EXPECT_NEAR(force(5).x, -hertz(node_radius, 0.02), 100 * round_off * second);
}

}  // namespace
}  // namespace furrow
