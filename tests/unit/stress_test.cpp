// Stress of a disc of radius R and volume V under contact forces, by hand.
#include "physics/stress.h"

#include <gtest/gtest.h>

namespace furrow {
namespace {

using Eigen::Vector2d;
constexpr double radius = 0.25;  // m
constexpr double volume = 0.5;   // m^3
constexpr double push = 8;       // N; R F / V = 4 Pa a contact
constexpr double round_off = 1e-14;

Stress moments(std::initializer_list<std::pair<Vector2d, Vector2d>> contacts) {
  Stress s = Stress::Zero();
  for (const auto& [branch, force] : contacts) s += stress_moment(branch, force) / volume;
  return s;
}

TEST(DiscStress, PressedFromTwoSidesIsUniaxialCompression) {
  const Stress s = moments({{{radius, 0}, {-push, 0}}, {{-radius, 0}, {push, 0}}});
  EXPECT_NEAR(s(0, 0), -8, round_off);
  EXPECT_EQ(s(1, 1), 0);
  EXPECT_EQ(s(0, 1), 0);
  EXPECT_NEAR(von_mises(s), 8, round_off * 8);
}

TEST(DiscStress, PressedFromFourSidesIsIsotropic) {
  const Stress s = moments(
      {{{radius, 0}, {-push, 0}}, {{-radius, 0}, {push, 0}}, {{0, radius}, {0, -push}}, {{0, -radius}, {0, push}}});
  EXPECT_NEAR(s(0, 0), -8, round_off);
  EXPECT_NEAR(s(1, 1), -8, round_off);
  EXPECT_EQ(s(0, 1), 0);
  EXPECT_NEAR(von_mises(s), 8, round_off * 8);  // in the plane: s, not zero
}

TEST(DiscStress, TangentialForcesThatDoNotTurnItAreShear) {
  const Stress s = moments(
      {{{radius, 0}, {0, push}}, {{-radius, 0}, {0, -push}}, {{0, radius}, {push, 0}}, {{0, -radius}, {-push, 0}}});
  EXPECT_EQ(s(0, 0), 0);
  EXPECT_EQ(s(1, 1), 0);
  EXPECT_NEAR(s(0, 1), 8, round_off);
  EXPECT_NEAR(von_mises(s), 8 * std::sqrt(3.0), round_off * 14);
}

TEST(DiscStress, IsSymmetricAndBlindToTurning) {
  const Stress s = moments({{{radius, 0}, {0, push}}, {{0, radius}, {-push, 0}}});  // both turn it counter-clockwise
  EXPECT_EQ(s(0, 1), s(1, 0));
  EXPECT_NEAR(s(0, 1), 0, round_off);
}

TEST(VonMises, OfAGeneralState) {
  Stress s;
  s << 3, 2, 2, -1;  // 9 + 3 + 1 + 12
  EXPECT_NEAR(von_mises(s), 5, round_off * 5);
}

}  // namespace
}  // namespace furrow
