// Mass and inertia of a disc in its two readings.
#include "physics/disc.h"

#include <gtest/gtest.h>

namespace furrow {
namespace {

constexpr double round_off = 1e-14;

TEST(DiscVolume, OfADiscIsAreaTimesDepth) { EXPECT_NEAR(disc_volume(2, 0.25), 3.14159265358979323846, round_off * 3); }

TEST(DiscVolume, OfASphere) { EXPECT_NEAR(sphere_volume(3), 36 * 3.14159265358979323846, round_off * 113); }

TEST(DiscInertia, IsHalfForADiscAndTwoFifthsForASphere) {
  EXPECT_NEAR(disc_inertia(3, 2), 6, round_off * 6);
  EXPECT_NEAR(sphere_inertia(3, 2), 4.8, round_off * 5);
}

}  // namespace
}  // namespace furrow
