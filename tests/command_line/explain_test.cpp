// Every number that `explain` derives from a scene, against its closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace {

class Explain : public furrow::test::Program {
 protected:
  // What `explain` says of the scene; its exit code is kept.
  std::string explain(const std::string& scene, const std::string& options = "") {
    put("s.toml", scene);
    code_ = furrow("explain s.toml " + options).code;
    errors_ = err();
    return out();
  }

  // All numbers after the first line that begins with `part` and holds `word`.
  static std::vector<double> numbers(const std::string& text, const std::string& part, const std::string& word) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t at = line.find(word);
      if (at == std::string::npos || line.find_first_not_of(' ') != line.find(part)) continue;
      static const std::regex number(R"(-?\d+\.?\d*(e[+-]?\d+)?)");
      const std::string rest = line.substr(line.find(part) + part.size());
      std::vector<double> found;
      for (std::sregex_iterator one(rest.begin(), rest.end(), number), end; one != end; ++one)
        found.push_back(std::stod(one->str()));
      return found;
    }
    ADD_FAILURE() << "no line '" << part << " ... " << word << "' in\n" << text;
    return {};
  }

  // As printed: with so many digits.
  static void expect(double got, double want, int digits) {
    EXPECT_NEAR(got, want, 0.6 * std::pow(10, 1 - digits) * std::fabs(want));
  }

  std::string errors_;
  int code_ = -1;
};

// Discs of sand and steel on a floor, one pressed 1 mm into it, one flying at 3 m/s.
const std::string discs = R"(
title = "Explained"
[model]
gravity = 2.5
disc_depth = 0.5
[time]
step = 1e-5
end = 1e-3
[contact]
damping_factor = 0.3
friction = 0.4
rolling_friction = 0.02
[[contact.pair]]
materials = ["sand", "steel"]
damping_factor = 1.5
friction = 0.25
[[material]]
name = "sand"
density = 2000.0
young = 1e6
poisson = 0.25
[[material]]
name = "steel"
density = 8000.0
young = 4e6
shear = 1.6e6
[[material]]
name = "rock"
rigid = true
[[disc]]
position = [0.0, 0.049]
radius = 0.05
material = "sand"
[[disc]]
position = [1.0, 0.5]
radius = 0.02
velocity = [3.0, 0.0]
material = "steel"
[[wall]]
point = [0.0, 0.0]
normal = [0.0, 1.0]
material = "rock"
)";

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

// One spring of omega = sqrt(k/m), no damping: verlet and symplectic Euler hold to 2/omega, rk4 to 2.828/omega.
const std::string spring = R"(
title = "Spring"
[time]
step = 1e-2
end = 1.0
method = "verlet"
[output]
interval = 0.5
[[material]]
name = "soft"
young = 1e6
poisson = 0.25
[[lattice]]
name = "spring"
origin = [0.0, 0.0]
rows = 1
columns = 2
spacing = 1.0
node_mass = 2.0
material = "soft"
fixed_columns = [0]
structural = { stiffness = 800.0, damping = 0.0 }
)";

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

// By hand: 16.5 k s, 10.25 k s^3, 2 k s of three columns of springs all alike; the rod by d = 4 sqrt(EI/EA).
TEST_F(Explain, SaysWhichBeamALatticeIs) {
  const std::string lattice = R"(
title = "Stem"
time = { end = 0.1, step = 1e-4 }
material = [{ name = "soft", young = 1e6, poisson = 0.25 }]
[[lattice]]
name = "stem"
origin = [0.0, 0.0]
rows = 10
columns = 3
spacing = 0.01
node_mass = 5.0
material = "soft"
fixed_rows = [0, 1]
structural = { stiffness = 1e4, damping = 50.0, strength = 40.0 }
shear = { stiffness = 1e4, damping = 50.0, strength = 40.0 }
bending = { stiffness = 1e4, damping = 50.0, strength = 40.0 }
)";
  const std::string text = explain(lattice);
  ASSERT_EQ(code_, 0) << errors_;
  EXPECT_NE(text.find("EA = 1650 N, EI = 0.1025 N m^2, GA = 200 N, nu = 0.25"), std::string::npos) << text;
  EXPECT_NE(text.find("diameter 0.03153 m, young 2.114e+06 Pa"), std::string::npos) << text;
  EXPECT_NE(text.find("tears in tension at 330 N, in bending at 2.05 N m"), std::string::npos) << text;
}

TEST_F(Explain, CountsWhatIsModelled) {
  const std::string text = explain(discs);
  // 2 discs: x, y, vx, vy, spin; room for springs and one dummy slot; 7 of the ledger.
  const int springs = static_cast<int>(numbers(text, "tangential springs", "room for").at(0));
  EXPECT_EQ(numbers(text, "modelled (", "numbers of state").at(0), 2 * 5 + springs + 1 + 7);
  EXPECT_EQ(numbers(text, "discs", "numbers each").at(0), 2);
  EXPECT_EQ(numbers(text, "discs", "numbers each").at(1), 5);
  EXPECT_NE(text.find("1 wall, 0 plates"), std::string::npos);
  const std::string lattice = explain(spring);
  EXPECT_EQ(numbers(lattice, "modelled (", "numbers of state").at(0), 4 + 7);
  EXPECT_EQ(numbers(lattice, "lattice nodes", "free").at(0), 1);
  EXPECT_NE(lattice.find("1 free, 4 numbers each; 1 fixed, none"), std::string::npos);
  EXPECT_NE(lattice.find("1: 1 structural, 0 shear, 0 bending"), std::string::npos);
  EXPECT_NE(lattice.find("its structural links never tear"), std::string::npos);
  EXPECT_NE(lattice.find("has no shear links"), std::string::npos);
  EXPECT_NE(lattice.find("has no bending links"), std::string::npos);
}

TEST_F(Explain, SaysWhatIsLeftOutOnlyWhereItIs) {
  const std::string with = explain(discs);
  for (const char* not_left_out : {"every friction coefficient is zero", "rolling friction coefficient is zero",
                                   "no discs", "model.gravity = 0", "do not touch each other"})
    EXPECT_EQ(with.find(not_left_out), std::string::npos) << not_left_out;
  std::string without = discs;
  without.replace(without.find("gravity = 2.5"), 13, "gravity = 0.0");
  without.replace(without.find("rolling_friction = 0.02"), 23, "");
  const std::string text = explain(without);
  EXPECT_NE(text.find("model.gravity = 0"), std::string::npos) << text;
  EXPECT_NE(text.find("every rolling friction coefficient is zero"), std::string::npos) << text;
  EXPECT_EQ(text.find("no spins, no tangential springs"), std::string::npos) << text;
  EXPECT_NE(explain(spring).find("no discs"), std::string::npos);
}

// A bed whose own step is so long that it blows up while it settles.
TEST_F(Explain, DivergesWithExitThreeWhereItsBedDoes) {
  std::string scene = discs + "[settle]\nspeed = 1e-3\nstep = 0.05\n";
  const std::string text = explain(scene);
  EXPECT_EQ(code_, 3) << text;
  EXPECT_NE(errors_.find("furrow: error: while settling"), std::string::npos) << errors_;
  EXPECT_NE(text.find("E* ="), std::string::npos) << "what it knew before is said";
}

}  // namespace
