// Two discs that meet spinning: alike with opposite spins, or unequal.
//
//   equal and opposite spins: no slip, nothing happens
//   gross sliding, m a disc's own mass, m* the pair's:
//     vy' = vy - mu (1 + e) vn m*/m
//     omega' = omega - mu (1 + e) vn m*/m / (c R)
//
// Sources: Chung and Ooi 2011 (Granular Matter 13, 643), test 8; Newton's third law.
#include <string>

#include "verification/check.h"
#include "verification/oblique_scenes.h"

namespace furrow::verification::oblique_impact {
namespace {

TEST(ObliqueImpact, EqualAndOppositeSpinsPassUnchanged) {
  requirement("tangential.no_slip");
  for (const RoundBody& body : {disc, sphere}) {
    Scene scene = plane(alloy, body);
    scene.wall.clear();
    scene.disc = {{{-alloy.radius, 0}, alloy.radius, {0.2, 0}, 7, "body"},
                  {{alloy.radius, 0}, alloy.radius, {-0.2, 0}, -7, "body"}};
    const double time = contact_time(alloy, body.mass(alloy.density, alloy.radius), 0.2);
    const Ran ran = run_scene(scene, "rk4", time / 2000, 2 * time);
    for (const int i : {0, 1}) {
      const std::string name = ", " + body.name + " " + std::to_string(i);
      expect("spin [rad/s]" + name, ran.y[ran.system.spin_of(i)], i == 0 ? 7 : -7, exact("w R - w R is zero"));
      expect("vy [m/s]" + name, ran.y[ran.system.vy_of(i)], 0, exact("no slip, no force"));
    }
    expect("e, " + body.name, (ran.y[ran.system.vx_of(1)] - ran.y[ran.system.vx_of(0)]) / 0.4,
           clipped(alloy.restitution),
           absolute(1.3e-5, "truncation of order 5/4, 6.3e-6 measured at n = 2000, doubled"));
  }
}

TEST(ObliqueImpact, UnequalPartnersShareTheImpulses) {
  requirement("tangential.unequal_partner");
  // Test 8: R 0.1 m against 0.5 m, the second 1000 times as dense (then nearly test 6), or as dense as the first.
  const double e = clipped(alloy.restitution);
  constexpr double vn = 0.2;
  for (const RoundBody& body : {disc, sphere}) {
    for (const double factor : {1.0, 1000.0}) {
      Scene scene = plane(alloy, body);
      scene.wall.clear();
      scene.material[1] = {
          .name = "other", .density = factor * alloy.density, .young = alloy.young, .poisson = alloy.poisson};
      scene.disc = {{{0, 0}, 0.1, {vn, 0}, 10, "body"}, {{0.6 * (1 - 1e-15), 0}, 0.5, {0, 0}, 0, "other"}};
      const double m1 = body.mass(alloy.density, 0.1);
      const double m2 = factor * body.mass(alloy.density, 0.5);
      const double reduced = m1 * m2 / (m1 + m2);
      const double time = contact_time(alloy, reduced, vn);
      const Ran ran = run_scene(scene, "rk4", 2 * time / steps, 2 * time);
      const double turn = alloy.friction * (1 + e) * vn * time / 0.6 / 2;  // rad, of the line of centres
      const Tolerance turning =
          absolute(turn / alloy.friction, "the normal impulse, 1/mu times the other, turns so far");
      const double given = alloy.friction * (1 + e) * vn * reduced;  // N s
      const std::string name = ", " + body.name + ", density " + std::to_string(int(factor)) + " to 1";
      expect("first, vy / (mu (1 + e) vn)" + name, ran.y[ran.system.vy_of(0)] * m1 / given, -1, turning);
      expect("second, vy m / (mu (1 + e) vn m*)" + name, ran.y[ran.system.vy_of(1)] * m2 / given, 1, turning);
      expect("first, change of spin" + name, (ran.y[ran.system.spin_of(0)] - 10) * 0.1 * m1 / given, -1 / body.c,
             turning);
      expect("second, change of spin" + name, ran.y[ran.system.spin_of(1)] * 0.5 * m2 / given, -1 / body.c, turning);
    }
  }
}

}  // namespace
}  // namespace furrow::verification::oblique_impact
