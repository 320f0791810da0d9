// What furrow says of the stiffest part of a scene, against a Jacobian made by differences of the right-hand side.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "run/stiffness.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// Of one body alone, its neighbours held: the greatest eigenvalues of its stiffness and damping for each mass, of the
// coordinates x, y and, of a disc with friction, angle. A tangential spring xi acts as a stiffness, since xi' is the
// slip:  K = -da/dx - (da/dxi)(dxi'/dv),  C = -da/dv.
struct OwnModes {
  double stiffness, damping;  // 1/s^2, 1/s
};

OwnModes modes_by_differences(const System& system, const State& y, int body) {
  const bool spins = system.has_friction() && body < system.parts().disc.count();
  const int n = spins ? 3 : 2;
  const int springs = system.has_friction() ? system.spring_count() : 0;
  const auto velocity = [&](int axis) {
    return axis == 0 ? system.vx_of(body) : axis == 1 ? system.vy_of(body) : system.spin_of(body);
  };
  const auto change = [&](int number, double by) {
    State up = y, down = y;
    up[number] += by;
    down[number] -= by;
    State one = rates(system, 0, up);
    const State other = rates(system, 0, down);
    for (std::size_t k = 0; k < one.size(); ++k) one[k] = (one[k] - other[k]) / (2 * by);
    return one;
  };
  const double mass = mass_of(system, body);
  const auto weight = [&](int axis) {
    return std::sqrt(axis < 2 ? mass : system.parts().disc.inertia[body]);  // makes both matrices symmetric
  };
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n), c = k, of_spring(n, springs), by_velocity(springs, n);
  for (int column = 0; column < n; ++column) {
    if (column < 2) {
      const State at = change(column == 0 ? system.x_of(body) : system.y_of(body), 1e-9);
      for (int row = 0; row < n; ++row) k(row, column) -= at[velocity(row)];
    }
    const State at = change(velocity(column), 1e-9);
    for (int row = 0; row < n; ++row) c(row, column) = -at[velocity(row)];
    for (int s = 0; s < springs; ++s) by_velocity(s, column) = at[system.first_spring() + s];
  }
  for (int s = 0; s < springs; ++s) {
    const State at = change(system.first_spring() + s, 1e-11);
    for (int row = 0; row < n; ++row) of_spring(row, s) = at[velocity(row)];
  }
  k -= of_spring * by_velocity;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      k(row, column) *= weight(row) / weight(column);
      c(row, column) *= weight(row) / weight(column);
    }
  }
  const auto greatest = [](const Eigen::MatrixXd& m) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (m + m.transpose())).eigenvalues().maxCoeff();
  };
  return {greatest(k), greatest(c)};
}

// The advice leaves out how a pressed contact turns with its body, Fe over the distance against Sn: of the order of the
// overlap over the radius, 1e-4 in these scenes.
constexpr double turning = 5e-4;

void expect_modes(const Standing& s, int body, const std::string& name) {
  const OwnModes want = modes_by_differences(s.system, s.y, body);
  const StiffPart got = stiffest_part(s.system, 0, s.y);
  EXPECT_EQ(got.name, name);
  const double omega = std::sqrt(want.stiffness);
  EXPECT_NEAR(got.oscillator.omega, omega, turning * omega);
  EXPECT_NEAR(got.oscillator.zeta, want.damping / (2 * omega), turning * want.damping / omega + 1e-9);
}

Scene rubbing(double rolling) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.2;
  scene.contact.friction = 0.5;
  scene.contact.rolling_friction = rolling;
  return scene;
}

TEST(StepAdvice, OfADiscBetweenTwoWallsIsItsOwnJacobian) {
  for (const MomentArm moment_arm : {MomentArm::contact_point, MomentArm::radius}) {
    Scene scene = rubbing(0);
    scene.model.moment_arm = moment_arm;
    scene.disc = {disc({0, 0}, 0.1)};
    scene.wall = {wall({0, -0.09999}, {0, 1}), wall({-0.09998, 0}, {1, 0})};
    const Standing s(scene);
    expect_modes(s, 0, "disc 0");
    EXPECT_EQ(stiffest_part(s.system, 0, s.y).contacts, 2);
  }
}

TEST(StepAdvice, OfADiscAmongDiscsIsThatOfTheLightestWithAllItsContacts) {
  Scene scene = rubbing(0);
  scene.disc = {disc({0.14999, 0}, 0.1), disc({0, 0}, 0.05), disc({-0.0749, 0.12975}, 0.1), disc({-0.2, -0.3}, 0.05)};
  const Standing s(scene);
  expect_modes(s, 1, "disc 1");
  EXPECT_EQ(stiffest_part(s.system, 0, s.y).contacts, 2);
}

// At rest a rolling disc is braked by mu_r R* Fn/w0 per rad/s: here more than anything else, and then it spins.
TEST(StepAdvice, KnowsSpinAndRollingAtRest) {
  Scene scene = rubbing(0.5);
  scene.disc = {disc({0, 0.0999}, 0.1)};
  scene.wall = {wall({0, 0}, {0, 1})};
  for (const double smoothing : {1.0, 1e-3}) {
    scene.model.rolling_smoothing = smoothing;
    const Standing s(scene);
    expect_modes(s, 0, "disc 0");
    EXPECT_TRUE(stiffest_part(s.system, 0, s.y).spins);
  }
}

// Pressed hard on a slick floor, and hardly on a wall that rubs: it is the floor that drives it, by a motion up and
// down.
TEST(StepAdvice, KnowsAMotionThatIsNoSpin) {
  Scene scene = rubbing(0);
  scene.material.push_back(elastic_material("slick"));
  scene.contact.pair = {{.materials = {"soft", "slick"}, .friction = 0}};
  scene.disc = {disc({0, 0.0999}, 0.1)};
  scene.wall = {wall({0, 0}, {0, 1}), wall({-0.0999999, 0}, {1, 0})};
  scene.wall[0].material = "slick";
  const Standing s(scene);
  expect_modes(s, 0, "disc 0");
  EXPECT_FALSE(stiffest_part(s.system, 0, s.y).spins);
}

// A disc on a border three tenths of the way along: each of its two nodes feels its share of the force, and moves the
// contact by its share.
TEST(StepAdvice, OfADiscOnALatticeIsSharedByTwoNodes) {
  for (const bool light_nodes : {true, false}) {
    Scene scene = empty_scene();
    scene.contact.damping_factor = 0.2;
    Lattice l = lattice({0, 0}, 1, 2, 1);
    l.name = "border";
    l.node_mass = light_nodes ? 0.01 : 1000;
    l.structural = link_kind(5, 0);
    scene.lattice = {l};
    scene.disc = {disc({0.3, 0.09999}, 0.1)};
    const Standing s(scene);
    ASSERT_EQ(s.system.parts().disc.count(), 1);
    if (light_nodes) {
      expect_modes(s, 1, "node (row 0, column 0) of lattice border");  // it has seven tenths
      EXPECT_EQ(stiffest_part(s.system, 0, s.y).contacts, 1);
    } else {
      expect_modes(s, 0, "disc 0");
    }
  }
}

TEST(StepAdvice, OfANodeIsThatOfItsContactsAndLinks) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.3;
  Lattice l = lattice({0, 0.5}, 2, 2, 1);
  l.name = "stem";
  l.fixed_columns = {1};
  l.structural = link_kind(1e3, 7);
  l.shear = link_kind(500, 3);
  scene.lattice = {l};
  scene.wall = {wall({-1e-5, 0}, {1, 0})};
  expect_modes(Standing(scene), 0, "node (row 0, column 0) of lattice stem");
  scene.wall[0].point.x = 1e-5;  // now it is pressed into both nodes
  Standing pressed(scene);
  expect_modes(pressed, 0, "node (row 0, column 0) of lattice stem");
}

TEST(StepAdvice, ADamperOnTheWholeVelocityBrakesBothWays) {
  for (const Damper damper : {Damper::axial, Damper::full}) {
    Scene scene = empty_scene();
    Lattice l = lattice({0, 0}, 2, 2, 1);
    l.name = "stem";
    l.fixed_rows = {0};
    l.damper = damper;
    l.structural = link_kind(1e3, 40);
    l.shear = link_kind(500, 30);
    scene.lattice = {l};
    expect_modes(Standing(scene), 0, "node (row 1, column 0) of lattice stem");
  }
}

TEST(StepAdvice, ATornLinkDrivesNothing) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 1, 3, 1);
  l.name = "strand";
  l.fixed_columns = {0};
  l.structural = link_kind(100, 0, 10);
  l.node = {node_setting(0, 1, {0.2, 0})};
  scene.lattice = {l};
  const Standing s(scene);
  ASSERT_TRUE(s.system.torn(0));
  EXPECT_NEAR(stiffest_part(s.system, 0, s.y).oscillator.omega, std::sqrt(100.0 / 2), 1e-9);
  EXPECT_EQ(
      stiffest_bond(s.system, 0, s.y, -1).name,
      "the structural link from node (row 0, column 1) of lattice strand to node (row 0, column 2) of lattice strand");
}

// A part is judged by |lambda|: omega (zeta + sqrt(zeta^2 - 1)) when it creeps, omega when it swings.
TEST(StepAdvice, TheFastestMotionMayBeTheMostDamped) {
  const auto two = [](double damping) {
    Scene scene = empty_scene();
    for (const auto& [name, kind] : {std::pair{"swings", link_kind(1e4, 0)}, {"creeps", link_kind(100, damping)}}) {
      Lattice l = lattice({0, scene.lattice.empty() ? 0.0 : 5.0}, 1, 2, 1);
      l.name = name;
      l.fixed_columns = {0};
      l.structural = kind;
      scene.lattice.push_back(l);
    }
    const Standing s(scene);
    return stiffest_part(s.system, 0, s.y);
  };
  // |lambda| of the first: sqrt(1e4/2) = 70.7 1/s. Of the second, nearly c/m.
  EXPECT_EQ(two(150).name, "node (row 0, column 1) of lattice creeps");
  EXPECT_NEAR(two(150).oscillator.zeta, 150 / (2 * std::sqrt(100.0 * 2)), 1e-9);
  EXPECT_EQ(two(140).name, "node (row 0, column 1) of lattice swings");
  EXPECT_NEAR(two(140).oscillator.omega, std::sqrt(1e4 / 2), 1e-9);
  EXPECT_EQ(two(140).oscillator.zeta, 0);
}

TEST(StepAdvice, ADamperWithoutASpringIsARateAlone) {
  Scene scene = single_spring(0, 5);
  const Standing s(scene);
  const StiffPart part = stiffest_part(s.system, 0, s.y);
  EXPECT_NEAR(2 * part.oscillator.omega * part.oscillator.zeta, 5.0 / 2, 1e-9);
  EXPECT_LE(part.oscillator.omega, 1.001e-6 * 2.5);
}

TEST(StepAdvice, OfNothingIsEmpty) {
  Scene scene = empty_scene();
  scene.disc = {disc({0, 0}, 0.1)};
  const Standing s(scene);
  EXPECT_EQ(stiffest_part(s.system, 0, s.y).name, "");
  EXPECT_EQ(stiffest_part(s.system, 0, s.y).oscillator.omega, 0);
  EXPECT_EQ(stiffest_bond(s.system, 0, s.y, 0).name, "");
  EXPECT_TRUE(step_warnings(s.system, 0, s.y, "pece", 1e9).empty());
}

}  // namespace
}  // namespace furrow
