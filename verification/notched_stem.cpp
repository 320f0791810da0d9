// Links that differ: a weak region, a stiff one, a notch from which a strip tears.
//
//   two regions of one row of links each in line: F = k1 x1 = k2 x2, so the strip of both yields by F/k1 + F/k2
//   a strip cut through at one edge: linear statics of its links, assembled here; the first to tear is that with the
//   greatest share of its strength, at the load strength/force per load
//
// Source: statics.
#include <algorithm>
#include <cmath>
#include <string>

#include "verification/at_rest.h"
#include "verification/bare_lattice.h"
#include "verification/check.h"
#include "verification/own_notch.h"

namespace furrow::verification::notched_stem {
namespace {

constexpr double mass = 0.1, strength = 40;  // kg, N

Scene strip(int rows, int columns, double shear) {
  Scene scene = bare_lattice(rows, columns, s, mass);
  Lattice& l = scene.lattice[0];
  l.fixed_rows = {0};
  l.structural = {.stiffness = k, .strength = strength};
  l.shear = {.stiffness = shear, .strength = shear > 0 ? strength : infinity};
  return scene;
}

void pull(Lattice& l, double force) {
  for (int c = 0; c < l.columns; ++c) l.node.push_back({.row = l.rows - 1, .column = c, .force = {0, force}});
}

TEST(NotchedStem, RegionsYieldEachByItsStiffness) {
  requirement("lattice.regions");
  Scene scene = strip(3, 2, 0);
  pull(scene.lattice[0], 1);
  scene.lattice[0].link = {{.rows = {0, 1}, .stiffness = 500}, {.rows = {1, 2}, .stiffness_factor = 0.2}};
  const System system(scene);
  const State y = at_rest(system, 0, system.initial_state(), 1e-7);
  expect("stretch of the lower row of links [m]", y[system.y_of(0)] - s, 1.0 / 500, relative(1e-9, "round-off"));
  expect("stretch of the upper row of links [m]", y[system.y_of(2)] - y[system.y_of(0)] - s, 1 / (0.2 * k),
         relative(1e-9, "round-off"));
}

TEST(NotchedStem, OneWeakLinkTearsFirst) {
  requirement("lattice.regions");
  Scene scene = strip(6, 2, 0);
  scene.lattice[0].link = {{.from = {3, 1}, .to = {2, 1}, .strength_factor = 0.5}};
  pull(scene.lattice[0], 0.6 * strength);
  System system(scene);
  State y = at_rest(system, 0, system.initial_state(), 1e-7);
  const std::vector<Tear> torn = system.jump(0, y).torn;
  expect("links torn", static_cast<double>(torn.size()), 1, exact("the other links hold 1/0.6 times as much"));
  expect_true("it is the one that was chosen",
              system.parts().link_name(torn.at(0).link).find("(row 2, column 1)") != std::string::npos,
              system.parts().link_name(torn.at(0).link));
}

TEST(NotchedStem, StripTearsAtTheRootOfItsNotch) {
  requirement("lattice.notch");
  constexpr int rows = 11, columns = 5;
  const std::vector<OwnLink> own = own_statics(rows, columns, k / 2, 5.5 * s, 1.2 * s);
  const auto weakest =
      std::max_element(own.begin(), own.end(), [](const OwnLink& a, const OwnLink& b) { return a.force < b.force; });
  const double critical = strength / weakest->force;  // N, on each column
  Scene scene = strip(rows, columns, k / 2);
  scene.lattice[0].link = {{.cut_from = Vec2{-s, 5.5 * s}, .cut_to = Vec2{1.2 * s, 5.5 * s}, .torn = true}};
  // The forces of small displacements: links 1e5 times as stiff and of the same strength stretch 4e-8 m.
  for (LinkKind* kind : {&scene.lattice[0].structural, &scene.lattice[0].shear}) kind->stiffness *= 1e5;
  for (const double share : {0.9999, 1.0001}) {
    Scene loaded = scene;
    pull(loaded.lattice[0], share * critical);
    System system(loaded);
    State y = at_rest(system, 0, system.initial_state(), 1e-8);
    const std::vector<Tear> torn = system.jump(0, y).torn;
    const std::string name = ", " + std::to_string(share) + " of the load that statics give";
    expect("links torn" + name, static_cast<double>(torn.size()), share < 1 ? 0 : 1, exact("a count"));
    if (torn.empty()) continue;
    expect("first node of the torn link" + name, system.parts().link.a[torn[0].link], weakest->a, exact("an index"));
    expect("second node of the torn link" + name, system.parts().link.b[torn[0].link], weakest->b, exact("an index"));
  }
}

}  // namespace
}  // namespace furrow::verification::notched_stem
