// What is read off a state, against numbers worked out by hand for small scenes.
#include "run/observe.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

constexpr double pi_ = 3.14159265358979323846;
constexpr double modulus = 1e6 / 1.875;      // Pa, E* of the elastic material with itself
constexpr double shear_modulus = 4e5 / 3.5;  // Pa, G*
constexpr double round_off = 1e-11;          // relative: an overlap is a small difference of larger numbers

double hertz(double reduced_radius, double overlap) {
  return 4.0 / 3 * modulus * std::sqrt(reduced_radius) * overlap * std::sqrt(overlap);
}

struct Seen {
  explicit Seen(const Scene& scene) : system(scene), y(system.initial_state()) { now = observe(system, 0, y); }
  System system;
  State y;
  Observation now;
};

TEST(PlateForce, IsMinusTheForceOnTheBodies) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.2;
  scene.contact.friction = 0.3;
  scene.disc = {disc({-0.09, 0.5}, 0.1, {0.3, 0.4}), disc({2.08, 0.5}, 0.1, {0, 0.4}, 3)};
  scene.plate = {plate({0, 0}, 1, 1, {0.5, 0}), plate({1.5, 0}, 0.5, 1, {0.5, 0})};
  scene.lattice = {lattice({0.95, 0.5}, 1, 1, 1)};
  const Seen s(scene);
  ASSERT_EQ(s.now.plate.size(), 2u);
  const State dydt = rates(s.system, 0, s.y);
  const Vec2 left = force_on(s.system, dydt, 0);
  const Vec2 right = force_on(s.system, dydt, 1);
  const Vec2 node = force_on(s.system, dydt, 2);
  EXPECT_LT(left.x, 0);
  EXPECT_NE(left.y, 0);
  EXPECT_GT(node.x, 0);
  EXPECT_NEAR(s.now.plate[0].x, -(left.x + node.x), round_off * std::fabs(left.x));
  EXPECT_NEAR(s.now.plate[0].y, -(left.y + node.y), round_off * std::fabs(left.x));
  EXPECT_NEAR(s.now.plate[1].x, -right.x, round_off * std::fabs(right.x));
  EXPECT_NEAR(s.now.plate[1].y, -right.y, round_off * std::fabs(right.x));
}

TEST(Energy, KineticCountsSpins) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.disc = {disc({0, 0}, 0.1, {3, 4}, 10)};
  const double mass = 1000 * pi_ * 0.01;
  const double want = 0.5 * mass * 25 + 0.5 * (0.5 * mass * 0.01) * 100;
  EXPECT_NEAR(Seen(scene).now.energy.kinetic, want, round_off * want);
}

TEST(Energy, OfHeightLoadAndSprings) {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.disc = {disc({7, 2}, 0.1)};
  Lattice l = lattice({0, 0}, 1, 3, 1);  // 2 kg a node
  l.gravity = true;
  l.structural = link_kind(100, 0);
  l.node = {node_setting(0, 1, {0.25, 0}, {}, {3, 5}), node_setting(0, 2, {0, 3}, {1, 0})};
  scene.lattice = {l};
  const Energies e = Seen(scene).now.energy;
  const double mass = 1000 * pi_ * 0.01;
  EXPECT_NEAR(e.gravity, 9.81 * (mass * 2 + 2 * 3), round_off * 600);
  EXPECT_NEAR(e.kinetic, 0.5 * 2 * 1, round_off);
  // Load energy is counted from the start of the scene.
  EXPECT_EQ(e.load, 0);
  const double second = std::hypot(0.75, 3) - 1;
  EXPECT_NEAR(e.springs, 50 * (0.0625 + second * second), round_off * 200);
}

TEST(Energy, LoadFallsAsItsNodeGives) {
  Scene scene = empty_scene();
  scene.lattice = {lattice({0, 0}, 1, 1, 1)};
  scene.lattice[0].node = {node_setting(0, 0, {}, {}, {3, 5})};
  Seen s(scene);
  s.y[s.system.x_of(0)] += 2;
  s.y[s.system.y_of(0)] -= 1;
  EXPECT_NEAR(observe(s.system, 0, s.y).energy.load, -(3.0 * 2 - 5.0 * 1), round_off);
}

TEST(Energy, OfContactsCountsNormalAndTangentialSprings) {
  Scene scene = empty_scene();
  scene.contact.friction = 100;
  scene.disc = {disc({0, 0.09}, 0.1)};
  scene.wall = {wall({0, 0}, {0, 1})};
  Seen s(scene);
  s.system.jump(0, s.y);
  s.y[s.system.first_spring()] = 0.002;
  const double stiffness = 8 * shear_modulus * std::sqrt(0.1 * 0.01);
  const double want = 0.4 * hertz(0.1, 0.01) * 0.01 + 0.5 * stiffness * 0.002 * 0.002;
  EXPECT_NEAR(observe(s.system, 0, s.y).energy.contact_elastic, want, round_off * want);
}

TEST(Momentum, LinearAndAngularWithSpins) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.5;
  scene.disc = {disc({2, 3}, 0.1, {4, 5}, 6)};
  Lattice l = lattice({-1, 7}, 1, 2, 1);
  l.fixed_columns = {1};
  l.node = {node_setting(0, 0, {}, {0.5, -0.25})};
  scene.lattice = {l};
  const double mass = 1000 * pi_ * 0.01;
  const Momentum p = Seen(scene).now.momentum;
  EXPECT_NEAR(p.x, mass * 4 + 2 * 0.5, round_off * 100);
  EXPECT_NEAR(p.y, mass * 5 - 2 * 0.25, round_off * 100);
  EXPECT_NEAR(p.angular, mass * (2 * 5 - 3 * 4) + 0.5 * mass * 0.01 * 6 + 2 * (-1 * -0.25 - 7 * 0.5), round_off * 100);
}

TEST(Overlap, TheGreatestRelativeOneIsNamed) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0.09}, 0.1), disc({5, 0.47}, 0.5), disc({0, 0.27}, 0.1)};
  scene.wall = {wall({9, 0}, {0, 1})};
  const Observation seen = Seen(scene).now;
  EXPECT_EQ(seen.contacts, 3);
  EXPECT_NEAR(seen.overlap.depth, 0.02, 1e-15);  // 0.03 m into the floor is more, but of a larger disc
  EXPECT_NEAR(seen.overlap.relative, 0.2, 1e-14);
  EXPECT_EQ(seen.overlap.between, "disc 0 and disc 2");
}

TEST(Overlap, IsNoneWhereNothingTouches) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1)};
  const Observation seen = Seen(scene).now;
  EXPECT_EQ(seen.contacts, 0);
  EXPECT_EQ(seen.overlap.depth, 0);
  EXPECT_EQ(seen.overlap.between, "");
}

TEST(Overlap, OfANodeIsRelativeToItsContactRadius) {
  Scene scene = empty_scene();
  scene.plate = {plate({0, 0}, 1, 1)};
  Lattice l = lattice({0.002, 0.5}, 1, 1, 1);
  l.name = "stem";
  l.contact_radius = 0.01;
  scene.lattice = {l};
  const Observation seen = Seen(scene).now;
  EXPECT_NEAR(seen.overlap.relative, 0.2, 1e-14);
  EXPECT_EQ(seen.overlap.between, "node (row 0, column 0) of lattice stem and plate 0");
}

TEST(DiscStresses, OfADiscBetweenTwoWallsIsUniaxialCompression) {
  Scene scene = empty_scene();
  scene.model.disc_depth = 0.5;
  scene.disc = {disc({0, 0}, 0.1), disc({0, 5}, 0.1)};
  scene.wall = {wall({-0.09, 0}, {1, 0}), wall({0.09, 0}, {-1, 0})};
  scene.disc[1].position.x = 0;
  const Seen s(scene);
  const std::vector<Stress> stress = disc_stresses(s.system, 0, s.y);
  ASSERT_EQ(stress.size(), 2u);
  const double want = -2 * 0.09 * hertz(0.1, 0.01) / (pi_ * 0.01 * 0.5);
  EXPECT_NEAR(stress[0](0, 0), want, -round_off * want);
  EXPECT_EQ(stress[0](1, 1), 0);
  EXPECT_EQ(stress[0](0, 1), 0);
}

TEST(DiscStresses, BothDiscsOfAContactFeelIt) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1), disc({0, 0.28}, 0.2)};
  const Seen s(scene);
  const std::vector<Stress> stress = disc_stresses(s.system, 0, s.y);
  const double force = hertz(0.1 * 0.2 / 0.3, 0.02);
  EXPECT_NEAR(stress[0](1, 1), -0.09 * force / (pi_ * 0.01), round_off * force * 10);  // the arm ends amid the overlap
  EXPECT_NEAR(stress[1](1, 1), -0.19 * force / (pi_ * 0.04), round_off * force * 10);
}

TEST(LinkForces, AreTensionsAndZeroWhereTorn) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 1, 4, 1);
  l.structural = link_kind(100, 9, 30);
  l.node = {node_setting(0, 2, {0.25, 0}), node_setting(0, 3, {0.75, 0}, {1, 1})};
  scene.lattice = {l};
  Seen s(scene);
  EXPECT_EQ(link_forces(s.system, 0, s.y), (std::vector<double>{0, 25, 50}));
  s.system.jump(0, s.y);
  EXPECT_EQ(link_forces(s.system, 0, s.y), (std::vector<double>{0, 25, 0}));
}

TEST(GreatestSpeed, OfDiscsAndNodes) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1, {3, 4})};
  scene.lattice = {lattice({5, 0}, 1, 1, 1)};
  EXPECT_EQ(greatest_speed(Seen(scene).system, Seen(scene).y), 5);
  scene.lattice[0].node = {node_setting(0, 0, {}, {-5, 12})};
  EXPECT_EQ(greatest_speed(Seen(scene).system, Seen(scene).y), 13);
}

// Of ten that move at 1 to 10 m/s a share s leaves out the floor(10 s) fastest.
TEST(GreatestSpeed, LeavesOutAShareOfTheFastest) {
  Scene scene = empty_scene();
  for (int k = 0; k < 10; ++k) scene.disc.push_back(disc({1.0 * k, 0}, 0.1, {1.0 + (7 * k) % 10, 0}));
  const Seen s(scene);
  for (const auto& [share, speed] : {std::pair{0.0, 10}, {0.05, 10}, {0.1, 9}, {0.15, 9}, {0.5, 5}, {0.99, 1}})
    EXPECT_EQ(greatest_speed(s.system, s.y, share), speed) << share;
  EXPECT_EQ(greatest_speed(Seen(empty_scene()).system, Seen(empty_scene()).y, 0.5), 0);
}

TEST(SurfaceHeight, IsTheMeanOfTheTopsInStrips) {
  Scene scene = empty_scene();
  EXPECT_EQ(surface_height(Seen(scene).system, Seen(scene).y), 0);
  // Two strips of 0.2 m: the tops are 0.5 + 0.1 and 0.1 + 0.1; the disc below counts only for the mean width.
  scene.disc = {disc({0.1, 0.5}, 0.1), disc({0.1, 0.1}, 0.1), disc({0.3, 0.1}, 0.1)};
  EXPECT_NEAR(surface_height(Seen(scene).system, Seen(scene).y), 0.4, 1e-15);
  // With a gap of one strip between them, which has no top.
  scene.disc[2].position.x = 0.5;
  EXPECT_NEAR(surface_height(Seen(scene).system, Seen(scene).y), 0.4, 1e-15);
}

}  // namespace
}  // namespace furrow
