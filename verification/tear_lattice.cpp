// Which links of a lattice tear: each kind at its own strength, mirror images alike, two at their limit together.
//
//   stretched by a strain e along its rows:
//     structural links along them  s e
//     shear links                  s (sqrt((1 + e)^2 + 1) - sqrt(2))
//     bending links along them     2 s e
//   energy lost with a link of stretch x:  k x^2/2
//
// Source: geometry.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
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

TEST(Tear, MirrorImagesTearInTheSameSteps) {
  requirement("tear.order_of_storage");
  constexpr int columns = 6;
  using Ends = std::pair<std::pair<int, int>, std::pair<int, int>>;
  // Steps and ends (row, column) of the links torn; `mirrored` counts columns from the right.
  const auto tears = [](bool mirrored) {
    const auto place = [&](int column) { return mirrored ? columns - 1 - column : column; };
    Scene scene = lattice_scene(4, columns);
    scene.lattice[0].shear = scene.lattice[0].structural;
    scene.lattice[0].bending = {.stiffness = 300, .damping = 1, .strength = 1.5};
    scene.lattice[0].node = {{.row = 3, .column = place(1), .velocity = {mirrored ? 0.2 : -0.2, 0.3}},
                             {.row = 0, .column = place(3), .velocity = {mirrored ? -0.1 : 0.1, -0.4}}};
    const Torn torn = run_and_tear(scene, 1e-3, 0.5);
    const NodeArrays& node = torn.ran.system.parts().node;
    const LinkArrays& link = torn.ran.system.parts().link;
    std::set<std::pair<long, Ends>> all;
    for (const Tear& tear : torn.tears) {
      const std::pair a(node.row[link.a[tear.link]], place(node.column[link.a[tear.link]]));
      const std::pair b(node.row[link.b[tear.link]], place(node.column[link.b[tear.link]]));
      all.insert({std::lround(tear.time / 1e-3), std::minmax(a, b)});
    }
    return all;
  };
  const auto original = tears(false);
  expect_true("at least ten links tear", original.size() >= 10, "else the comparison says little");
  expect_true("the mirror image tears the same links in the same steps", original == tears(true),
              "links are stored from the left: the mirror image has them in another order");
}

TEST(Tear, TwoLinksAtTheirLimitTearTogether) {
  requirement("tear.order_of_storage");
  Scene scene = lattice_scene(1, 3);
  scene.lattice[0].fixed_columns = {0, 2};
  scene.lattice[0].node = {{.column = 1, .velocity = {0, 1}}};
  const Torn torn = run_and_tear(scene, 1e-3, 0.1);
  expect("links torn", static_cast<double>(torn.tears.size()), 2, exact("both springs are stretched alike"));
  expect("time between them [s]", torn.tears.at(1).time - torn.tears.at(0).time, 0, exact("the same step"));
}

}  // namespace
}  // namespace furrow::verification::tear
