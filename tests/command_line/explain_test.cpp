// Every number that `explain` derives from a scene, against its closed form.
#include "explain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

using furrow::test::discs;
using furrow::test::Explain;
using furrow::test::spring;

TEST_F(Explain, ContactsByPairHaveTheirModuliFrictionAndDampingRatio) {
  const std::string text = explain(discs);
  ASSERT_EQ(code_, 0) << errors_;
  // 1/E* = sum (1 - nu^2)/E,  1/G* = sum (2 - nu)/G; steel: nu = E/2G - 1 = 0.25, G = 1.6e6; sand: G = 4e5.
  const double sand = (1 - 0.0625) / 1e6, steel = (1 - 0.0625) / 4e6;  // 1/Pa
  const double sand_shear = 1.75 / 4e5, steel_shear = 1.75 / 1.6e6;    // 1/Pa
  struct Pair {
    std::string name;
    double compliance, shear, friction;
  };
  for (const Pair& p : {Pair{"sand - sand", 2 * sand, 2 * sand_shear, 0.4},
                        {"sand - steel", sand + steel, sand_shear + steel_shear, 0.25},
                        {"sand - rock", sand, sand_shear, 0.4},
                        {"steel - steel", 2 * steel, 2 * steel_shear, 0.4},
                        {"steel - rock", steel, steel_shear, 0.4}}) {
    const std::vector<double> found = numbers(text, p.name, "E* =");
    ASSERT_EQ(found.size(), 4u) << p.name;
    expect(found[0], 1 / p.compliance, 6);
    expect(found[1], 1 / p.shear, 6);
    EXPECT_EQ(found[2], p.friction) << p.name;
    EXPECT_EQ(found[3], 0.02) << p.name;
  }
  EXPECT_NE(text.find("rock - rock"), std::string::npos);
  EXPECT_NE(text.find("both rigid: they must not meet"), std::string::npos);
  // Ratio sqrt(5/6) beta. The second pair's is beyond critical.
  std::vector<double> ratios;
  std::vector<bool> creeps;
  std::istringstream lines(text.substr(text.find("contacts, by pair")));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("damping ratio ");
    if (line.find("at any overlap") == std::string::npos) continue;
    ratios.push_back(std::stod(line.substr(at + 14)));
    creeps.push_back(line.find("beyond critical") != std::string::npos);
  }
  ASSERT_EQ(ratios.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    expect(ratios[k], std::sqrt(5.0 / 6) * (k == 1 ? 1.5 : 0.3), 4);
    EXPECT_EQ(creeps[k], k == 1);
  }
}

// Hertz: m* v^2/2 = 8/15 E* sqrt(R*) d^(5/2); the contact lasts 2.943 d/v.
TEST_F(Explain, TheSmallestDiscMeetsItsLike) {
  const std::string text = explain(discs);
  const double radius = 0.02, modulus = 4e6 / (2 * 0.9375), speed = 3;  // m, Pa, m/s
  const double mass = 8000 * std::numbers::pi * radius * radius * 0.5;  // kg
  const std::vector<double> disc = numbers(text, "smallest disc", "R =");
  ASSERT_EQ(disc.size(), 4u);  // the last is the 2 of kg m^2
  EXPECT_EQ(disc[0], radius);
  expect(disc[1], mass, 6);
  expect(disc[2], mass * radius * radius / 2, 6);
  const double overlap = std::pow(mass / 2 * speed * speed / 2 / (8.0 / 15 * modulus * std::sqrt(radius / 2)), 0.4);
  const std::vector<double> meeting = numbers(text, "two of them, elastic", "closing at");
  ASSERT_GE(meeting.size(), 5u);
  EXPECT_EQ(meeting[0], speed);
  expect(meeting[1], overlap, 3);
  expect(meeting[2], overlap / radius, 3);
  expect(meeting[3], 4.0 / 3 * modulus * std::sqrt(radius / 2) * std::pow(overlap, 1.5), 4);
  // 4 sqrt(pi)/5 Gamma(2/5)/Gamma(9/10)
  expect(meeting[4], 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9) * overlap / speed, 4);
  const double stiffness = 2 * modulus * std::sqrt(radius / 2 * overlap);
  const std::vector<double> damping = numbers(text, "critical damping", "at that overlap");
  ASSERT_GE(damping.size(), 2u);
  expect(damping[0], 2 * std::sqrt(stiffness * mass / 2), 4);
  expect(damping[1], 2 * std::sqrt(5.0 / 6) * 0.3 * std::sqrt(stiffness * mass / 2), 4);
}

TEST_F(Explain, SpeedIsThatOfTheFastestPlateOrDiscAndOneIfAllRest) {
  std::string scene = discs;
  const auto replace = [&](const std::string& old, const std::string& with) {
    scene.replace(scene.find(old), old.size(), with);
  };
  replace("velocity = [3.0, 0.0]", "velocity = [0.3, 0.4]");
  EXPECT_EQ(numbers(explain(scene), "two of them, elastic", "closing at").at(0), 0.5);
  const std::string plated = scene + R"(
[[plate]]
name = "tool"
left_edge = -5.0
lower_edge = 0.2
width = 0.01
height = 0.1
velocity = [-0.6, 0.8]
material = "rock"
)";
  EXPECT_EQ(numbers(explain(plated), "two of them, elastic", "closing at").at(0), 1);
  replace("velocity = [0.3, 0.4]\n", "");
  EXPECT_EQ(numbers(explain(scene), "two of them, elastic", "closing at").at(0), 1);
}

TEST_F(Explain, WhereItStandsAndItsStiffestPart) {
  const std::string text = explain(discs, "--method verlet");
  EXPECT_EQ(numbers(text, "contacts", "1").at(0), 1);
  const std::vector<double> overlap = numbers(text, "greatest overlap", "of the radius");
  expect(overlap.at(0), 1e-3, 3);
  expect(overlap.at(1), 0.02, 3);
  EXPECT_NE(text.find("between disc 0 and wall 0"), std::string::npos) << text;
  EXPECT_NE(text.find("disc 0, 1 contacts, its neighbours held, its fastest motion a spin"), std::string::npos) << text;
  // Sn = 2 E* sqrt(R d), St = 8 G* sqrt(R d); along the tangent with the spin St (1/m + arm^2/I).
  const double modulus = 1e6 / 0.9375, shear = 4e5 / 1.75, root = std::sqrt(0.05 * 1e-3);
  const double mass = 2000 * std::numbers::pi * 0.0025 * 0.5, inertia = mass * 0.0025 / 2, arm = 0.049;
  const double normal = 2 * modulus * root / mass;
  const double tangential = 8 * shear * root * (1 / mass + arm * arm / inertia);
  const std::vector<double> oscillator = numbers(text, "omega =", "rad/s");
  expect(oscillator.at(0), std::sqrt(std::max(normal, tangential)), 4);
  // Damping by the greatest of its own modes: tangential or the rolling at rest, coupled; at least the first alone.
  const double viscous =
      2 * std::sqrt(5.0 / 6) * 0.3 * std::sqrt(8 * shear * root * mass) * (1 / mass + arm * arm / inertia);
  EXPECT_GE(oscillator.at(1), 0.999 * viscous / (2 * std::sqrt(tangential)));
}

TEST_F(Explain, StableStepsAreThoseOfTheOscillator) {
  const std::string text = explain(spring);
  ASSERT_EQ(code_, 0) << errors_;
  EXPECT_EQ(numbers(text, "omega =", "rad/s").at(0), 20);
  EXPECT_EQ(numbers(text, "omega =", "rad/s").at(1), 0);
  for (const auto& [method, limit] : {std::pair{"verlet", 2.0}, {"symplectic_euler", 2.0}, {"rk4", std::sqrt(8.0)}}) {
    const std::vector<double> found = numbers(text, method, " s;");
    EXPECT_NEAR(found.at(0), limit / 20, 6e-3 * limit / 20) << method;  // three digits, found within 0.1 %
    EXPECT_NEAR(found.at(1), found.at(0) / 2, 6e-3 * limit / 20) << method;
  }
  for (const char* controlled : {"pece_adaptive", "rkc"})
    EXPECT_NE(text.find("chooses its own step", text.find(std::string("  ") + controlled + " ")), std::string::npos);
  EXPECT_NE(text.find("the scene's step"), std::string::npos);
  EXPECT_NE(text.find("0.01 s: well inside"), std::string::npos);
}

TEST_F(Explain, TheScenesStepIsWellInsideUpToHalfOfItsLimit) {
  EXPECT_NE(explain(spring, "--dt 0.0499").find("0.0499 s: well inside"), std::string::npos);
  const std::string near = explain(spring, "--dt 0.0501");
  EXPECT_NE(near.find("0.0501 s: NOT safely inside"), std::string::npos) << near;
  EXPECT_NE(near.find("is near the stability limit of verlet"), std::string::npos) << near;
  const std::string beyond = explain(spring, "--dt 0.101");
  EXPECT_NE(beyond.find("is beyond the stability limit of verlet"), std::string::npos) << beyond;
  EXPECT_EQ(code_, 0);
}

}  // namespace
