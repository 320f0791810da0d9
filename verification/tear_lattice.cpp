// Which links of a lattice tear: each kind at its own strength.
//
//   stretched by a strain e along its rows:
//     structural links along them  s e
//     shear links                  s (sqrt((1 + e)^2 + 1) - sqrt(2))
//     bending links along them     2 s e
//   energy lost with a link of stretch x:  k x^2/2
//
// Source: geometry.
#include <cmath>
#include <map>
#include <string>

#include "verification/check.h"
#include "verification/tear_scenes.h"

namespace furrow::verification::tear {
namespace {

TEST(Tear, EachKindOfLinkHasItsOwnStrength) {
  requirement("tear.own_strength");
  constexpr double shear = 700, bending = 200;                                                                 // N/m
  const auto diagonal = [](double strain) { return spacing * (std::hypot(1 + strain, 1) - std::sqrt(2.0)); };  // m
  Scene scene = lattice_scene(3, 4);
  Lattice& lattice = scene.lattice[0];
  lattice.structural.strength = stiffness * spacing * 0.01;
  lattice.shear = {.stiffness = shear, .strength = shear * diagonal(0.02)};
  lattice.bending = {.stiffness = bending, .strength = bending * 2 * spacing * 0.03};
  const auto torn_by = [&](double strain, TearRule rule) {
    lattice.tear = rule;
    lattice.node.clear();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        lattice.node.push_back({.row = row, .column = column, .displacement = {strain * column * spacing, 0}});
    System system(scene);
    State y = system.initial_state();
    std::map<LinkClass, double> torn;
    for (const Tear& tear : system.jump(0, y).torn) ++torn[system.parts().link.kind[tear.link]];
    return std::pair(torn, y[system.ledger_of(tear_energy)]);
  };
  constexpr double hair = 1e-9;
  for (const double strain : {0.01, 0.02, 0.03}) {
    for (const double side : {-hair, hair}) {
      auto [torn, energy] = torn_by(strain * (1 + side), TearRule::tension);
      const double at = strain * (1 + side);
      const std::string name = " at a stretch of " + std::to_string(strain) + (side < 0 ? " less 1e-9" : " plus 1e-9");
      const double along = at > 0.01 ? 9 : 0, across = at > 0.02 ? 12 : 0, skip = at > 0.03 ? 6 : 0;
      expect("structural links torn" + name, torn[LinkClass::structural], along, exact("a count: 3 rows of 3"));
      expect("shear links torn" + name, torn[LinkClass::shear], across, exact("a count: 6 cells of 2"));
      expect("bending links torn" + name, torn[LinkClass::bending], skip, exact("a count: 3 rows of 2"));
      const double stretch = spacing * at;
      expect("tear energy [J]" + name, energy,
             0.5 * (along * stiffness * stretch * stretch + across * shear * diagonal(at) * diagonal(at) +
                    skip * bending * 4 * stretch * stretch),
             absolute(6e-16,
                      "round-off: stretches good to an ulp of 0.3 m, 6e-17, times forces of up to 3 N, as a random "
                      "walk over 27 links, doubled"));
    }
  }
  const auto squeezed = torn_by(-0.15, TearRule::tension).first;
  expect("links torn by compression", static_cast<double>(squeezed.size()), 0, exact("tension only"));
  auto crushed = torn_by(-0.15, TearRule::magnitude).first;
  expect("links torn by compression, rule of magnitude",
         crushed[LinkClass::structural] + crushed[LinkClass::shear] + crushed[LinkClass::bending], 27,
         exact("all that are not upright"));
}

}  // namespace
}  // namespace furrow::verification::tear
