// What a tear leaves open discs meet as they met the old border: a whole face, the link across a cell that has lost its
// corner, a single node.
//
//   nodes of mass m_n, at the fraction t of their segment:
//     1/m* = 1/m_disc + ((1 - t)^2 + t^2)/m_n
//     J = (1 + e) m* v on the disc, (1 - t) J and t J on the nodes
//
// Source: algebra, as of an unbroken border in segment_impact.cpp.
#include <string>

#include "verification/check.h"
#include "verification/new_face_scenes.h"

namespace furrow::verification::coupling {
namespace {

struct Impact {
  std::string name;
  Vec2 at, towards;  // m, the point that is hit; unit vector of the disc's way
  double share;
  int first, second;  // nodes, row times 3 and column
  std::function<bool(const Ends&)> gone;
};

void expect_impact(const Impact& i) {
  constexpr double e = 0.5, start = radius * (1 - 1e-14);
  const double t = i.share, reduced = reduced_mass(((1 - t) * (1 - t) + t * t) / node_mass);
  const double given = (1 + e) * reduced * closing;  // N s
  Scene scene = soft_lattice_and_disc({i.at.x - start * i.towards.x, i.at.y - start * i.towards.y},
                                      {closing * i.towards.x, closing * i.towards.y});
  scene.contact.restitution = e;
  scene.model.pull = true;
  System system = torn_system(scene, i.gone);
  const double time = 2.943275184324047 * deepest(reduced) / closing;
  const State y = run_torn(system, time / 4000.5, 1.3 * time);
  const auto along = [&](int body) {
    return y[system.vx_of(body)] * i.towards.x + y[system.vy_of(body)] * i.towards.y;
  };
  const Tolerance truncation = absolute(1.9e-6, "truncation of order 5/4, as of an unbroken border");
  expect(i.name + ": disc, change of velocity m / J", (closing - along(0)) * disc_mass / given, 1, truncation);
  expect(i.name + ": first node, velocity m / J", along(1 + i.first) * node_mass / given, 1 - t, truncation);
  if (i.first != i.second)
    expect(i.name + ": second node, velocity m / J", along(1 + i.second) * node_mass / given, t, truncation);
}

// Between the rows 1 and 2.
bool across_the_middle(const Ends& link) { return link.row_a < 2 && link.row_b > 1; }

bool at_corner(const Ends& link) { return link.row_a == 0 && link.column_a == 0; }

bool at_inner_node(const Ends& link) {
  return (link.row_a == 1 && link.column_a == 1) || (link.row_b == 1 && link.column_b == 1);
}

TEST(NewFaces, AWholeFaceIsMetAsTheOldOne) {
  requirement("tear.new_faces");
  for (const double t : {0.0, 0.3, 0.5}) {
    const std::string which = ", t " + std::to_string(t).substr(0, 3);
    const double x = t * spacing;
    expect_impact({"upper half" + which, {x, 2 * spacing}, {0, 1}, t, 6, 7, across_the_middle});
    expect_impact({"lower half" + which, {x, spacing}, {0, -1}, t, 3, 4, across_the_middle});
  }
}

TEST(NewFaces, TheLinkAcrossACellIsMetWhereItsCornerIsLost) {
  requirement("tear.new_faces");
  const double along = std::sqrt(0.5);
  expect_impact({"corner", {spacing / 2, spacing / 2}, {along, along}, 0.5, 1, 3, at_corner});
}

TEST(NewFaces, ASingleNodeIsMet) {
  requirement("tear.new_faces");
  expect_impact({"inner node", {spacing, spacing}, {1, 0}, 0, 4, 4, at_inner_node});
  expect_impact({"corner node", {0, 0}, {0, 1}, 0, 0, 0, at_corner});
}

TEST(NewFaces, InnerNodesOfAWholeLatticeAreNotMet) {
  requirement("tear.new_faces");
  const System system(soft_lattice_and_disc({spacing, spacing + 0.5 * radius}, {}));
  int touching = 0;
  system.for_each_contact(0, system.initial_state(), [&](const Contact&) { ++touching; });
  expect("contacts of a disc in the midst of it", touching, 0,
         exact("the border is a spacing away, R is a fifth of it"));
}

}  // namespace
}  // namespace furrow::verification::coupling
