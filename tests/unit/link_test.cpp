// Spring and damper of a lattice: signs and numbers by hand, on the 3-4-5 triangle.
#include "physics/link.h"

#include <gtest/gtest.h>

namespace furrow {
namespace {

constexpr double round_off = 1e-13;

TEST(LinkForce, StretchedLinkPullsTogether) {
  const LinkForce f =
      link_force({3, 4}, {0, 0}, 4.5, 100, 0, Damper::axial);  // 0.5 m too long: 50 N along (-0.6, -0.8) on node i
  EXPECT_NEAR(f.spring, 50, round_off * 50);
  EXPECT_NEAR(f.fx, -30, round_off * 50);
  EXPECT_NEAR(f.fy, -40, round_off * 50);
}

TEST(LinkForce, CompressedLinkPushesApart) {
  const LinkForce f = link_force({3, 4}, {0, 0}, 6, 100, 0, Damper::axial);
  EXPECT_NEAR(f.spring, -100, round_off * 100);
  EXPECT_NEAR(f.fx, 60, round_off * 100);
  EXPECT_NEAR(f.fy, 80, round_off * 100);
}

TEST(LinkForce, IsZeroAtRest) {
  const LinkForce f = link_force({3, 4}, {0, 0}, 5, 100, 7, Damper::axial);
  EXPECT_EQ(f.fx, 0);
  EXPECT_EQ(f.fy, 0);
  EXPECT_EQ(f.damping, 0);
}

TEST(LinkForce, IsOppositeOnTheOtherNode) {
  const LinkForce i = link_force({3, 4}, {0.7, -0.2}, 4.5, 100, 7, Damper::axial);
  const LinkForce j = link_force({-3, -4}, {-0.7, 0.2}, 4.5, 100, 7, Damper::axial);
  EXPECT_EQ(i.fx, -j.fx);
  EXPECT_EQ(i.fy, -j.fy);
  EXPECT_EQ(i.spring, j.spring);
}

TEST(LinkDamper, AxialActsAlongTheLink) {
  // v = (1, 2) m/s: along (0.6, 0.8) it is 2.2 m/s; c = 10 N s/m gives 22 N back along the link, and takes 22 * 2.2 W.
  const LinkForce f = link_force({3, 4}, {1, 2}, 5, 100, 10, Damper::axial);
  EXPECT_NEAR(f.fx, -13.2, round_off * 22);
  EXPECT_NEAR(f.fy, -17.6, round_off * 22);
  EXPECT_NEAR(f.damping, 48.4, round_off * 48);
}

TEST(LinkDamper, FullActsOnTheWholeVelocity) {
  const LinkForce f = link_force({3, 4}, {1, 2}, 5, 100, 10, Damper::full);
  EXPECT_NEAR(f.fx, -10, round_off * 20);
  EXPECT_NEAR(f.fy, -20, round_off * 20);
  EXPECT_NEAR(f.damping, 50, round_off * 50);
}

TEST(LinkDamper, OnlyFullBrakesARigidRotation) {
  const LinkForce axial = link_force({3, 4}, {-4, 3}, 5, 100, 10, Damper::axial);  // v perpendicular to r
  EXPECT_NEAR(axial.fx, 0, round_off);
  EXPECT_NEAR(axial.fy, 0, round_off);
  EXPECT_NEAR(axial.damping, 0, round_off);
  const LinkForce full = link_force({3, 4}, {-4, 3}, 5, 100, 10, Damper::full);
  EXPECT_NEAR(full.fx, 40, round_off * 40);
  EXPECT_NEAR(full.fy, -30, round_off * 40);
  EXPECT_NEAR(full.damping, 250, round_off * 250);
}

}  // namespace
}  // namespace furrow
