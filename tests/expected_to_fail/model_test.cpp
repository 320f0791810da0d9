// What the model does not do yet.
#include <numbers>

#include "physics/rescaled_mindlin.h"
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

// Rescaled Mindlin with damping. A spring beyond its friction limit counts as far as the limit; held to that of the elastic
// force, mu Fe/St = mu E* d/(6 G*), its rate would be bounded however small the overlap. Held to that of the whole
// force it grows as d^(-1/4) d'/d, and runs end as invalid (exit 3).
TEST_F(ExpectedToFail, TheSpringOfADampedRescaledContactBeginsAtABoundedRate) {
  mended_in("tests/unit/contact_test.cpp");
  Scene scene = empty_scene();
  scene.model.law = ForceLaw::rescaled_mindlin;
  scene.contact.friction = 0.5;
  scene.contact.restitution = 0.5;
  scene.wall = {wall({0, 0}, {0, 1})};
  scene.disc = {disc({0, radius}, radius)};
  const ContactLaw law = make_parts(scene).law[0];
  const double approach = 0.1;  // m/s
  const Touch touch{1e-12, approach, 0, 1e-3, 0, radius, disc_mass};
  TouchForce force{};
  press(law, touch, force);
  ASSERT_GT(force.normal, 100 * force.elastic) << "it is damped";
  const double bound = law.friction * 4 * force.elastic / (force.shear_stiffness * touch.overlap) * approach;
  const double rate = std::fabs(rescaled_rate(law, touch, force));
  EXPECT_RIGHT(rate < bound) << "it is below eight times that of an undamped contact, " << bound << " m/s; it is "
                             << rate << " m/s";
}

}  // namespace
}  // namespace furrow::test
