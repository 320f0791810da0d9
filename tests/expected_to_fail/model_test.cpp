// What the model does not do yet.
#include <numbers>

#include "tests/expected_to_fail/expected_to_fail.h"
#include "tests/unit/watched_run.h"

namespace furrow::test {
namespace {

constexpr double modulus = 1e6 / (2 * (1 - 0.0625)), radius = 0.1;  // Pa, E* of scenes.h; m

const double disc_mass = 1000 * std::numbers::pi * radius * radius;  // kg

// A slope of 5 degrees, mu = 0.5, mu_r = 0.2: tan 5 deg = 0.087 is below both, so what stands stays where it is.
TEST_F(ExpectedToFail, ADiscRestsOnASlopeBelowItsRollingFriction) {
  mended_in("verification/rolling_resistance.cpp");
  const double slope = 5 * std::numbers::pi / 180;
  const double weight = 9.81 * disc_mass;
  const double overlap = std::pow(weight * std::cos(slope) / (4.0 / 3.0 * modulus * std::sqrt(radius)), 2.0 / 3.0);
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.contact.friction = 0.5;
  scene.contact.rolling_friction = 0.2;
  scene.contact.restitution = 0.5;
  scene.wall = {wall({0, 0}, {std::sin(slope), std::cos(slope)})};
  scene.disc = {disc({(radius - overlap) * std::sin(slope), (radius - overlap) * std::cos(slope)}, radius)};
  const Vec2 start = scene.disc[0].position;
  const WatchedRun r = watched(allowing_all(scene), "pece", 2e-4, 2);
  ASSERT_EQ(r.end.ending, Ending::finished) << r.end.reason;
  const double moved = std::hypot(r.y[0] - start.x, r.y[1] - start.y);
  EXPECT_RIGHT(moved < 0.02 * radius) << "it stays, but for the give of the contact, less than 0.02 R in 2 s; it moved "
                                      << moved / radius << " R";
}

}  // namespace
}  // namespace furrow::test
