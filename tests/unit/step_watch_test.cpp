// The watch over the step: judged while contacts deepen, not at each of them, and by the stiffest there was in the end.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "watched_run.h"

namespace furrow {
namespace {

using namespace test;

constexpr double modulus = 1e6 / (2 * (1 - 0.0625)), radius = 0.1;  // Pa, E* of scenes.h; m
const double mass = 1000 * std::numbers::pi * radius * radius;      // kg

// A disc that bounces on a wall, ever deeper with its speed; omega = sqrt(2 E* sqrt(R d) / m) at the deepest, and pece
// bears 1.287 on the imaginary axis.
double ratio_at_the_deepest(double speed, double step) {
  const double deepest = std::pow(0.5 * mass * speed * speed / (8.0 / 15.0 * modulus * std::sqrt(radius)), 0.4);
  return step * std::sqrt(2 * modulus * std::sqrt(radius * deepest) / mass) / 1.287;
}

TEST(StepWatch, WorstIsThatOfTheStiffestMomentWhereverItLiesBetweenTwoLooks) {
  constexpr double step = 1e-4;
  for (double speed = 0.02; speed < 0.3; speed *= 1.17) {
    Scene scene = empty_scene();
    scene.disc = {disc({0, radius}, radius, {0, -speed})};
    scene.wall = {wall({0, 0}, {0, 1})};
    const WatchedRun r = watched(allowing_all(scene), "pece", step, 0.4);
    ASSERT_EQ(r.end.ending, Ending::finished);
    const double worst = r.of(WatchKind::step).worst, deepest = ratio_at_the_deepest(speed, step);
    EXPECT_LT(worst, 1.002 * deepest) << speed;
    // Looked at where the overlap has grown by a tenth: of omega a fortieth.
    EXPECT_GT(worst, 0.974 * deepest) << speed;
  }
}

}  // namespace
}  // namespace furrow
