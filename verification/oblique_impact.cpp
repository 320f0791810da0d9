// A disc that strikes a plane obliquely or spinning so that it slides all the time, or up to that.
//
//   gross sliding, if vt > kappa mu (1 + e) vn:
//     vt' = vt - kappa mu (1 + e) vn
//     vx' = vx - mu (1 + e) vn
//     omega' = omega - mu (1 + e) vn / (c R)
//   e of a contact that never pulls:
//     e = exp(-beta/w (pi - atan2(2 beta w, w^2 - beta^2))),  w = sqrt(1 - beta^2)
//
// Sources: Chung and Ooi 2011 (Granular Matter 13, 643), tests 4 to 7; Schwager and Poeschel 2007 for e.
#include <cmath>
#include <string>

#include "verification/check.h"
#include "verification/oblique_scenes.h"

namespace furrow::verification::oblique_impact {
namespace {

TEST(ObliqueImpact, GrossSlidingFollowsCoulomb) {
  requirement("tangential.gross_sliding");
  const double e = clipped(alumina.restitution);
  const Tolerance truncation =
      absolute(5e-8, "truncation of order 5/4 at touch, 2.3e-8 measured at n = 20000, doubled");
  for (const RoundBody& body : {disc, sphere}) {
    for (const double angle : {35.0, 50.0, 70.0, 85.0}) {
      const double vn = 3.9 * std::cos(angle * pi / 180);
      const double vt = 3.9 * std::sin(angle * pi / 180);
      const After after = strike(alumina, body, vn, vt, 0);
      const double given = alumina.friction * (1 + e) * vn;
      expect("e" + degrees(body, angle), after.vy / vn, e, truncation);
      expect("loss of vx / (mu (1 + e) vn)" + degrees(body, angle), (vt - after.vx) / given, 1, truncation);
      expect("spin R / (mu (1 + e) vn)" + degrees(body, angle), after.spin * alumina.radius / given, -1 / body.c,
             truncation);
      expect("loss of vx / (mu (vn + vn'))" + degrees(body, angle),
             (vt - after.vx) / (alumina.friction * (vn + after.vy)), 1,
             absolute(1e-12, "round-off over 2e4 steps: the same Fn at every stage"));
    }
  }
}

TEST(ObliqueImpact, ConstantClosingSpeedSaturatesInSpin) {
  requirement("tangential.gross_sliding");
  // Test 5: R omega' / (mu vn) = -(1 + e) / c above vt / (mu vn) = kappa (1 + e), which is 6 for a disc, 7 for a
  // sphere.
  constexpr double vn = 5;
  const Tolerance sliding = absolute(2.2e-11, "truncation of order 5/2, 1.1e-11 measured at n = 20000, doubled");
  const Tolerance partial = absolute(4e-9, "truncation of order 2 where sticking and sliding meet: 2e-9, doubled");
  for (const RoundBody& body : {disc, sphere}) {
    for (const double ratio : {1.0, 3.0, 8.0, 12.0}) {
      const double vt = ratio * steel.friction * vn;
      const double scale = steel.friction * vn;
      const After after = strike(steel, body, vn, vt, 0);
      const double want = ratio > body.kappa() * 2
                              ? -2 / body.c
                              : -(vt - by_oracle(steel, body, vn, vt).slip) / body.kappa() / body.c / scale;
      expect("R omega' / (mu vn), " + body.name + ", vt / (mu vn) = " + std::to_string(int(ratio)),
             after.spin * steel.radius / scale, want, ratio > body.kappa() * 2 ? sliding : partial);
    }
  }
}

TEST(ObliqueImpact, SpinIsTurnedIntoMotionAlongThePlane) {
  requirement("tangential.gross_sliding");
  const double e = clipped(alloy.restitution);
  constexpr double vn = 0.2;
  const Tolerance truncation =
      absolute(1.1e-6, "truncation of order 5/4 at touch, 5.5e-7 measured at n = 20000, doubled");
  for (const RoundBody& body : {disc, sphere}) {
    for (const double sign : {1.0, -1.0}) {
      const double spin = sign * 10;  // rad/s; R omega = 1 m/s > kappa mu (1 + e) vn = 0.46
      const After after = strike(alloy, body, vn, 0, spin);
      const double given = alloy.friction * (1 + e) * vn * sign;
      const std::string name = ", " + body.name + (sign > 0 ? ", left about" : ", right about");
      expect("vx / (mu (1 + e) vn)" + name, after.vx / given, -1, truncation);
      expect("change of R omega / (mu (1 + e) vn)" + name, (after.spin - spin) * alloy.radius / given, -1 / body.c,
             truncation);
    }
  }
}

}  // namespace
}  // namespace furrow::verification::oblique_impact
