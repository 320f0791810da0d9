// Which links tear does not depend on the order in which they are stored: mirror images tear alike, and two links at
// their limit tear together.
//
// Source: symmetry.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "verification/check.h"
#include "verification/tear_scenes.h"

namespace furrow::verification::tear {
namespace {

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
