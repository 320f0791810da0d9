// What `explain` says of the validity of a scene's laws, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>

#include "program.h"

namespace furrow::test {
namespace {

constexpr double pi = std::numbers::pi;

// A rough disc of 20 mm, a plate 10 mm wide and a lattice of one material: E* = 1e6/1.875 Pa, beta = 0.4.
const std::string scene_text = R"(title = "Explained"
[model]
gravity = 9.81
rolling_smoothing = 0.25
[time]
step = 1e-5
end = 1e-3
[contact]
damping_factor = 0.4
friction = 0.5
rolling_friction = 0.1
[[material]]
name = "soft"
density = 1000.0
young = 1e6
poisson = 0.25
[[disc]]
position = [-0.1, 0.05]
radius = 0.02
material = "soft"
[[plate]]
left_edge = 0.0
lower_edge = 0.0
width = 0.01
height = 0.1
velocity = [0.0, 0.0]
material = "soft"
[[lattice]]
name = "stem"
origin = [0.2, 0.0]
rows = 3
columns = 3
spacing = 0.04
node_mass = 2.0
material = "soft"
auxiliary_points = 4
contact_radius = 0.03
structural = { stiffness = 1e4, damping = 1.0 }
shear = { stiffness = 1e4, damping = 1.0 }
[allow]
overlap = 0.5
through_plates = true
)";

class ExplainValidity : public Program {
 protected:
  // What stands behind the first line that begins with `begin`, up to the next line that is no continuation of it.
  std::string line_of(const std::string& begin) const {
    const std::string text = out();
    const std::size_t at = text.find("\n  " + begin);
    if (at == std::string::npos) {
      ADD_FAILURE() << "no line '" << begin << "' in\n" << text;
      return "";
    }
    return text.substr(at + 3 + begin.size(), text.find('\n', at + 1) - at - 3 - begin.size());
  }
  void expect_speeds(const std::string& pair, double elastic, double damped) const {
    const std::string line = line_of(pair);
    std::smatch found;
    ASSERT_TRUE(std::regex_search(line, found, std::regex("from (\\S+) m/s on; with its damping from (\\S+) m/s")))
        << line;
    EXPECT_NEAR(std::stod(found[1]), elastic, 0.006 * elastic) << "three digits";
    EXPECT_NEAR(std::stod(found[2]), damped, 0.006 * damped) << "three digits";
  }
};

// Work 8/15 E* sqrt(R*) d^(5/2) up to where centres pass: 2 R of two alike, R and half the plate's width, R at a border,
// half the width for a node. With z = d^(5/4) the damped contact is a linear oscillator of ratio beta: its peak is
// exp(-beta/r atan(r/beta)) of that of the undamped one, r = sqrt(1 - beta^2).
TEST_F(ExplainValidity, SpeedsOfPassingAreThoseOfTheWork) {
  put("s.toml", scene_text);
  ASSERT_EQ(furrow("explain s.toml").code, 0) << err();
  const double modulus = 1e6 / 1.875, radius = 0.02, mass = 1000 * pi * radius * radius;
  const auto speed = [&](double reduced_radius, double overlap, double reduced_mass) {
    return std::sqrt(2 * 8.0 / 15 * modulus * std::sqrt(reduced_radius) * std::pow(overlap, 2.5) / reduced_mass);
  };
  const double r = std::sqrt(1 - 0.16), peak = std::exp(-0.4 / r * std::atan(r / 0.4));
  for (const auto& [pair, elastic] : {std::pair{"disc of 0.02 m, its like", speed(radius / 2, 2 * radius, mass / 2)},
                                      {"disc of 0.02 m, plate 0", speed(radius, radius + 0.005, mass)},
                                      {"disc of 0.02 m, lattice 0", speed(radius, radius, mass)},
                                      {"node, plate 0", speed(0.03, 0.005, 2)}})
    expect_speeds(pair, elastic, elastic / peak);
}

TEST_F(ExplainValidity, SaysThatSmallDiscsPassBetweenThePoints) {
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  put("s.toml", with(with(scene_text, "radius = 0.02", "radius = 0.003"), "name = \"stem\"\n", ""));
  ASSERT_EQ(furrow("explain s.toml").code, 0) << err();
  EXPECT_EQ(out().find("nan"), std::string::npos) << out();
  EXPECT_NE(line_of("border of lattice 0").find("discs of radius 0.003 m pass between"), std::string::npos) << out();
  EXPECT_EQ(furrow("check s.toml").code, 0);
  EXPECT_NE(err().find("lattice[0].auxiliary_points: discs of radius 0.003 m pass between the points of its border, "
                       "which are 0.008 m apart: take at least 6 points, or 0, the whole border"),
            std::string::npos)
      << err();
}

// Four points on a segment of 40 mm are 8 mm apart: the nearest lies up to 4 mm beside the foot of the perpendicular.
TEST_F(ExplainValidity, TheCostOfAuxiliaryPointsIsTheirRoughness) {
  put("s.toml", scene_text);
  ASSERT_EQ(furrow("explain s.toml").code, 0) << err();
  const std::string line = line_of("border of stem");
  double points = 0, rough = 0, off = 0, radius = 0;
  ASSERT_EQ(
      std::sscanf(line.c_str(),
                  " %lf points on each segment: %lf m rough, the normal up to %lf degrees off for a disc of %lf m",
                  &points, &rough, &off, &radius),
      4)
      << line;
  EXPECT_EQ(points, 4);
  EXPECT_EQ(radius, 0.02);
  EXPECT_NEAR(rough, 0.02 - std::sqrt(0.02 * 0.02 - 0.004 * 0.004), 0.006 * 4e-4);
  EXPECT_NEAR(off, std::asin(0.004 / 0.02) * 180 / pi, 0.05 * 12);
  EXPECT_NE(out().find("auxiliary_points = 0 is smooth"), std::string::npos);
  put("s.toml", std::regex_replace(scene_text, std::regex("auxiliary_points = 4"), "auxiliary_points = 0"));
  ASSERT_EQ(furrow("explain s.toml").code, 0) << err();
  EXPECT_EQ(out().find("points on each segment"), std::string::npos) << out();
}

TEST_F(ExplainValidity, WhatTheModelDoesNotDoIsSaidWhereItMatters) {
  put("s.toml", scene_text);
  ASSERT_EQ(furrow("explain s.toml").code, 0) << err();
  EXPECT_NE(line_of("inner nodes").find("touch no disc; a link that tears opens the border"), std::string::npos);
  EXPECT_NE(line_of("rest by rolling").find("smoothed below 0.25 rad/s: it slows, but holds nothing still"),
            std::string::npos);
  put("s.toml", std::regex_replace(scene_text, std::regex("rolling_friction = 0.1"), "rolling_friction = 0.0"));
  ASSERT_EQ(furrow("explain s.toml").code, 0) << err();
  EXPECT_EQ(out().find("rest by rolling"), std::string::npos) << out();
}

TEST_F(ExplainValidity, WhatTheSceneAllowsIsSaidAndNoMore) {
  put("s.toml", scene_text);
  ASSERT_EQ(furrow("explain s.toml").code, 0) << err();
  EXPECT_NE(line_of("overlap   ").find("up to 0.5 of the smaller radius"), std::string::npos);
  EXPECT_NE(line_of("plates   ").find("centres may cross them"), std::string::npos);
  for (const char* other :
       {"energy made", "energy lost", "centres of discs may lie behind them", "cross their borders"})
    EXPECT_EQ(out().find(other), std::string::npos) << other;
  put("s.toml", scene_text.substr(0, scene_text.find("[allow]")));
  ASSERT_EQ(furrow("explain s.toml").code, 0) << err();
  EXPECT_EQ(out().find("allowed beyond the validity"), std::string::npos) << out();
}

}  // namespace
}  // namespace furrow::test
