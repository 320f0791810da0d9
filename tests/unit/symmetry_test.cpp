// What must hold whatever the law: action and reaction, balance of moments, mirror images, other labels, uniform
// motion.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

struct Sums {
  double x = 0, y = 0, moment = 0, size = 0;
};

// Of the forces on all bodies, and of their moments about the origin with the torques on the discs.
Sums sums(const System& system, const State& y) {
  const State dydt = rates(system, 0, y);
  Sums s;
  for (int body = 0; body < system.parts().bodies(); ++body) {
    const Vec2 f = force_on(system, dydt, body);
    s.x += f.x;
    s.y += f.y;
    s.moment += y[system.x_of(body)] * f.y - y[system.y_of(body)] * f.x;
    s.size += std::fabs(f.x) + std::fabs(f.y);
    if (system.has_friction() && body < system.parts().disc.count()) s.moment += torque_on(system, dydt, body);
  }
  return s;
}

// Two discs and a free lattice in touch, in motion, spinning and with wound-up tangential springs.
Scene entangled(double rolling_friction) {
  Scene scene = empty_scene();
  scene.contact.friction = 0.4;
  scene.contact.rolling_friction = rolling_friction;
  scene.contact.damping_factor = 0.3;
  scene.disc = {disc({0.31, 0.185}, 0.2, {0.3, -0.2}, 3), disc({0.5, 0.5}, 0.18, {-0.1, -0.4}, -7)};
  Lattice l = lattice({0, 0}, 2, 2, 1);
  l.origin = {0, -1};
  l.structural = link_kind(300, 5);
  l.shear = link_kind(200, 3);
  l.node = {node_setting(1, 0, {0.01, 0.005}, {0.2, 0.1}), node_setting(0, 1, {-0.1, 0.2}, {0.3, -0.5})};
  scene.lattice = {l};
  return scene;
}

State wound(System& system) {
  State y = system.initial_state();
  system.jump(0, y);
  for (int k = 0; k < system.spring_count(); ++k) y[system.first_spring() + k] = 1e-3 * (k % 2 == 0 ? 1 : -1.5);
  return y;
}

TEST(ActionAndReaction, ForcesOfAFreeClusterAddUpToNothing) {
  System system(entangled(0.2));
  const Sums s = sums(system, wound(system));
  EXPECT_GT(s.size, 100);
  EXPECT_NEAR(s.x, 0, 1e-14 * s.size);
  EXPECT_NEAR(s.y, 0, 1e-14 * s.size);
}

// The two arms add up to the distance of the centres, and the arm on the lattice ends in the point that shares the
// force.
TEST(ActionAndReaction, MomentsOfAFreeClusterAddUpToNothing) {
  System system(entangled(0));
  const Sums s = sums(system, wound(system));
  EXPECT_NEAR(s.moment, 0, 1e-14 * s.size);
}

TEST(ActionAndReaction, RollingMomentsOfTwoDiscsAreOpposite) {
  Scene scene = entangled(0.3);
  scene.lattice.clear();
  System system(scene);
  const State y = wound(system);
  EXPECT_NEAR(sums(system, y).moment, 0, 1e-14 * sums(system, y).size);
  State still = y;
  still[system.spin_of(0)] = still[system.spin_of(1)] = 0;
  EXPECT_NE(torque_on(system, rates(system, 0, y), 0), torque_on(system, rates(system, 0, still), 0));
}

// `moment_arm = "radius"`: both discs turned by R Ft, as the literature's closed forms have it; moments then do not
// balance.
TEST(MomentArm, OfTheWholeRadiusTurnsByRadiusTimesForce) {
  Scene scene = empty_scene();
  scene.model.moment_arm = MomentArm::radius;
  scene.contact.friction = 1e9;
  scene.disc = {disc({0, 0.27}, 0.3)};
  scene.wall = {wall({0, 0}, {0, 1})};
  for (const double arm : {0.3, 0.27}) {
    scene.model.moment_arm = arm == 0.3 ? MomentArm::radius : MomentArm::contact_point;
    System system(scene);
    const State y = wound(system);
    const State dydt = rates(system, 0, y);
    const Vec2 force = force_on(system, dydt, 0);
    EXPECT_GT(std::fabs(force.x), 1);
    EXPECT_NEAR(torque_on(system, dydt, 0), arm * force.x, 1e-13 * std::fabs(force.x));  // below the centre
  }
}

TEST(MomentArm, SurfaceOfASpinningDiscSlipsBySpinTimesArm) {
  Scene scene = empty_scene();
  scene.contact.friction = 1;
  scene.disc = {disc({0, 0.27}, 0.3, {0.5, 0}, 2)};
  scene.wall = {wall({0, 0}, {0, 1})};
  System system(scene);
  const State y = wound(system);
  const State dydt = rates(system, 0, y);
  // The wall is below: n = (0, -1), t = (1, 0); the lowest point moves at 0.5 + 2 * 0.27 m/s.
  EXPECT_NEAR(dydt[system.first_spring()], 1.04, 1e-15);
}

State after(const Scene& scene, double end) {
  System system(scene);
  State y = system.initial_state();
  const auto method = make_method("pece");
  RunPlan plan;
  plan.end = end;
  const RunEnd how = run(system, *method, y, plan, [](double, const State&, const JumpReport&) { return true; });
  EXPECT_EQ(how.ending, Ending::finished) << how.reason;
  return y;
}

constexpr double run_time = 0.03;  // s: 300 steps in which everything collides and links tear
// Round-off (1e-17 m) times what a few collisions make of it.
constexpr double same = 1e-10;

TEST(Symmetry, MirrorImageMovesAsTheMirrorImage) {
  const Scene scene = busy_scene();
  Scene mirror = scene;
  for (Disc& d : mirror.disc) {
    d.position.x *= -1;
    d.velocity.x *= -1;
    d.spin *= -1;
  }
  for (Wall& w : mirror.wall) {
    w.point.x *= -1;
    w.normal.x *= -1;
  }
  for (Plate& p : mirror.plate) {
    p.left_edge = -(p.left_edge + p.width);
    p.velocity.x *= -1;
  }
  for (Lattice& l : mirror.lattice) l.origin.x = -(l.origin.x + (l.columns - 1) * l.spacing);
  const System system(scene);
  const State one = after(scene, run_time);
  const State other = after(mirror, run_time);
  const int discs = system.parts().disc.count();
  for (int body = 0; body < system.parts().bodies(); ++body) {
    int image = body;
    if (body >= discs) image = discs + (body - discs) / 3 * 3 + 2 - (body - discs) % 3;  // rows of three free nodes
    EXPECT_NEAR(other[system.x_of(image)], -one[system.x_of(body)], same) << body;
    EXPECT_NEAR(other[system.y_of(image)], one[system.y_of(body)], same) << body;
    if (body >= discs) continue;
    EXPECT_NEAR(other[system.spin_of(body)], -one[system.spin_of(body)], 1e5 * same) << body;
  }
}

TEST(Symmetry, LabelsOfDiscsAndWallsDoNotMatter) {
  const Scene scene = busy_scene();
  Scene relabelled = scene;
  std::reverse(relabelled.disc.begin(), relabelled.disc.end());
  std::reverse(relabelled.wall.begin(), relabelled.wall.end());
  const System system(scene);
  const State one = after(scene, run_time);
  const State other = after(relabelled, run_time);
  const int discs = system.parts().disc.count();
  for (int body = 0; body < system.parts().bodies(); ++body) {
    const int label = body < discs ? discs - 1 - body : body;
    EXPECT_NEAR(other[system.x_of(label)], one[system.x_of(body)], same) << body;
    EXPECT_NEAR(other[system.y_of(label)], one[system.y_of(body)], same) << body;
  }
}

TEST(Symmetry, UniformMotionOfEverythingChangesNothing) {
  const Vec2 drift{0.7, -0.4};
  Scene scene = busy_scene();
  scene.wall.clear();  // walls cannot move
  scene.lattice[0].fixed_rows.clear();
  Scene moving = scene;
  for (Disc& d : moving.disc) d.velocity = {d.velocity.x + drift.x, d.velocity.y + drift.y};
  for (Plate& p : moving.plate) p.velocity = {p.velocity.x + drift.x, p.velocity.y + drift.y};
  for (Lattice& l : moving.lattice) {
    for (int k = 0; k < l.rows * l.columns; ++k) {
      l.node.push_back(node_setting(k / l.columns, k % l.columns, {}, drift));
    }
  }
  const System system(scene);
  const State one = after(scene, run_time);
  const State other = after(moving, run_time);
  for (int body = 0; body < system.parts().bodies(); ++body) {
    EXPECT_NEAR(other[system.x_of(body)], one[system.x_of(body)] + drift.x * run_time, same) << body;
    EXPECT_NEAR(other[system.y_of(body)], one[system.y_of(body)] + drift.y * run_time, same) << body;
  }
}

}  // namespace
}  // namespace furrow
