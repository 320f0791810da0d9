// The stiffest contact or link of a scene, and the warnings about steps near the limit of stability.
#include <gtest/gtest.h>

#include <cmath>

#include "run/stiffness.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

// Stiffer than what is left, but torn; stiffer still, but between two fixed nodes.
TEST(StiffestBond, PassesOverWhatIsTornAndWhatCannotMove) {
  Scene scene = empty_scene();
  for (const auto& [name, kind] :
       {std::pair{"torn", link_kind(1e4, 0, 10)}, {"held", link_kind(1e6, 0)}, {"left", link_kind(100, 0)}}) {
    Lattice l = lattice({0, 5.0 * static_cast<double>(scene.lattice.size())}, 1, 2, 1);
    l.name = name;
    l.fixed_columns = l.name == "held" ? std::vector<int>{0, 1} : std::vector<int>{0};
    l.structural = kind;
    if (l.name == "torn") l.node = {node_setting(0, 1, {0.2, 0})};
    scene.lattice.push_back(l);
  }
  const Standing s(scene);
  ASSERT_TRUE(s.system.torn(0));
  for (const int body : {-1, 0}) {
    const StiffPart bond = stiffest_bond(s.system, 0, s.y, body);
    EXPECT_NE(bond.name.find("lattice left"), std::string::npos) << bond.name;
    EXPECT_NEAR(bond.oscillator.omega, std::sqrt(100.0 / 2), 1e-9);
  }
}

// One contact or link between its two parts:  omega^2 = k (1/m_a + 1/m_b),  2 zeta omega = c (1/m_a + 1/m_b).
TEST(StiffestBond, IsTheReducedOscillatorOfTheOneOnTheBody) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 1, 4, 1);
  l.name = "strand";
  l.fixed_columns = {0};
  l.structural = link_kind(100, 3);
  scene.lattice = {l};
  l.name = "stiff";
  l.origin.y = 5;
  l.structural = link_kind(1000, 8);
  scene.lattice.push_back(l);
  const Standing s(scene);
  for (const auto& [body, k, c, masses] :
       {std::tuple{0, 100.0, 3.0, 1.0}, {2, 100.0, 3.0, 1.0}, {4, 1000.0, 8.0, 1.0}, {-1, 1000.0, 8.0, 1.0}}) {
    const StiffPart bond = stiffest_bond(s.system, 0, s.y, body);
    EXPECT_NEAR(bond.oscillator.omega, std::sqrt(k * masses), 1e-9) << body;  // 1/m_a + 1/m_b = 1/2 + 1/2
    EXPECT_NEAR(bond.oscillator.zeta, c * masses / (2 * std::sqrt(k * masses)), 1e-9) << body;
    EXPECT_NE(bond.name.find(body < 0 || body > 2 ? "lattice stiff" : "lattice strand"), std::string::npos)
        << bond.name;
  }
}

TEST(StiffestBond, OfAContactHasItsReducedMassAndViscosity) {
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.3;
  scene.disc = {disc({0, 0}, 0.1), disc({0.198, 0}, 0.1), disc({5, 0}, 0.1), disc({5, 0.28}, 0.2)};
  const Standing s(scene);
  const double mass = 1000 * 3.14159265358979323846 * 0.01, modulus = 1e6 / 1.875;  // kg, Pa
  const StiffPart first = stiffest_bond(s.system, 0, s.y, 1);
  EXPECT_EQ(first.name, "the contact of disc 0 and disc 1");
  const double stiffness = 2 * modulus * std::sqrt(0.05 * 0.002);
  EXPECT_NEAR(first.oscillator.omega, std::sqrt(stiffness / (mass / 2)), 1e-6);
  EXPECT_NEAR(first.oscillator.zeta, std::sqrt(5.0 / 6) * 0.3, 1e-9);  // at any overlap
  EXPECT_EQ(stiffest_bond(s.system, 0, s.y, 0).name, first.name);
  for (const int body : {2, 3, -1})
    EXPECT_EQ(stiffest_bond(s.system, 0, s.y, body).name, "the contact of disc 2 and disc 3");
}

// The threshold: half of the limit, since neighbours that move against a part make it up to twice as stiff.
TEST(StepWarnings, BeginAtHalfTheLimitAndSayMoreBeyondIt) {
  Scene scene = single_spring(100, 0);
  scene.lattice[0].name = "spring";
  const Standing s(scene);
  const double limit = largest_stable_step("verlet", {std::sqrt(50.0), 0});
  EXPECT_NEAR(limit, 2 / std::sqrt(50.0), 2e-3 * limit);
  const auto warned = [&](double step) {
    const std::vector<std::string> texts = step_warnings(s.system, 0, s.y, "verlet", step);
    return texts.empty() ? std::string() : texts.front();
  };
  EXPECT_EQ(warned(0.5 * limit), "");
  EXPECT_NE(warned(std::nextafter(0.5 * limit, 1)).find(" s is near the stability limit of verlet"), std::string::npos);
  EXPECT_NE(warned(limit).find("near"), std::string::npos);
  EXPECT_NE(warned(1.001 * limit)
                .find(" s is beyond the stability limit of verlet: node (row 0, column 1) of lattice "
                      "spring (0 contacts, damping ratio 0)"),
            std::string::npos)
      << warned(1.001 * limit);
  EXPECT_TRUE(step_warnings(s.system, 0, s.y, "pece_adaptive", 1e9).empty());
}

}  // namespace
}  // namespace furrow
