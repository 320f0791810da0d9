// The border of a lattice that tears.
#include <gtest/gtest.h>

#include <algorithm>

#include "watched_run.h"

namespace furrow {
namespace {

using namespace test;

constexpr double radius = 0.1;  // m

// Columns 0 to 3 of a lattice, of which column 0 is torn off by its stretched links at the start and flies away upward.
// What is left is a face of fixed nodes at x = 0.1 m; the border on the other side, at 0.3 m, is not reached.
Scene disc_and_torn_lattice() {
  Scene scene = empty_scene();
  scene.model.new_faces = true;
  Lattice l = lattice({0, 0}, 5, 4, 0.1);
  l.fixed_columns = {1, 2, 3};
  l.auxiliary_points = 0;
  l.structural = l.shear = link_kind(1e3, 0, 10);
  for (int row = 0; row < 5; ++row) l.node.push_back(node_setting(row, 0, {-0.05, 0}, {0, 20}));
  scene.lattice = {l};
  scene.disc = {disc({-0.2, 0.22}, radius, {0.5, 0})};
  return scene;
}

Scene disc_and_border_in_that_place() {
  Scene scene = disc_and_torn_lattice();
  Lattice l = lattice({0.1, 0}, 5, 3, 0.1);
  l.fixed_columns = {0, 1, 2};
  l.auxiliary_points = 0;
  scene.lattice = {l};
  return scene;
}

TEST(NewFaces, AFaceMadeByATearReflectsADiscLikeTheBorder) {
  const WatchedRun border = watched(disc_and_border_in_that_place(), "verlet", 1e-4, 0.7);
  ASSERT_EQ(border.end.ending, Ending::finished) << border.end.reason;
  ASSERT_NEAR(border.y[2], -0.5, 1e-5) << "an elastic impact on a fixed face";
  const WatchedRun torn = watched(allowing_all(disc_and_torn_lattice()), "verlet", 1e-4, 0.7);
  ASSERT_EQ(torn.end.ending, Ending::finished) << torn.end.reason;
  ASSERT_EQ(torn.tears, 13) << "5 structural and 8 shear links to column 0";
  const double vx = torn.y[2 * 6];  // one disc, five free nodes
  EXPECT_TRUE(std::fabs(vx - border.y[2]) < 1e-9)
      << "vx = " << border.y[2] << " m/s after the new face, as after a border; it was " << vx;
}

// ---- which segments there are ----

// Three rows of three nodes; a side or link across is named by its nodes, row times 3 and column.
Scene three_by_three(bool new_faces) {
  Scene scene = empty_scene();
  scene.model.new_faces = new_faces;
  Lattice l = lattice({0, 0}, 3, 3, 0.1);
  l.structural = l.shear = l.bending = link_kind(1e3, 0, 10);
  scene.lattice = {l};
  return scene;
}

using Segments = std::vector<std::pair<int, int>>;

Segments border_after(const Scene& scene, const Segments& torn) {
  const Parts parts = make_parts(scene);
  std::vector<int> links;
  for (int k = 0; k < parts.link.count(); ++k) {
    const std::pair ends(parts.link.a[k], parts.link.b[k]);
    if (std::find(torn.begin(), torn.end(), ends) != torn.end()) links.push_back(k);
  }
  EXPECT_EQ(links.size(), torn.size());
  System system(scene);
  DiscreteState discrete = system.discrete_state();
  discrete.torn = links;
  system.restore(discrete);
  Segments found;
  for (const int s : system.border()) found.push_back(std::minmax(parts.border.a[s], parts.border.b[s]));
  std::sort(found.begin(), found.end());
  return found;
}

const Segments whole{{0, 1}, {0, 3}, {1, 2}, {2, 5}, {3, 6}, {5, 8}, {6, 7}, {7, 8}};

TEST(NewFaces, AWholeLatticeHasItsFirstBorder) {
  EXPECT_EQ(border_after(three_by_three(true), {}), whole);
  EXPECT_EQ(border_after(three_by_three(false), {}), whole);
  EXPECT_EQ(border_after(three_by_three(false), {{0, 1}}), whole) << "torn segments keep their nodes";
}

TEST(NewFaces, ATornSideOpensItsCell) {
  EXPECT_EQ(border_after(three_by_three(true), {{0, 1}}),
            (Segments{{0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {2, 5}, {3, 4}, {3, 6}, {5, 8}, {6, 7}, {7, 8}}));
}

TEST(NewFaces, AnInnerSideOpensTheCellsOnEitherSide) {
  Segments want = whole;
  for (const auto& one : Segments{{0, 4}, {1, 3}, {1, 4}, {1, 5}, {2, 4}, {3, 4}, {4, 5}}) want.push_back(one);
  std::erase(want, std::pair(1, 4));
  std::sort(want.begin(), want.end());
  EXPECT_EQ(border_after(three_by_three(true), {{1, 4}}), want);
}

TEST(NewFaces, ALostCornerLeavesTheLinkAcrossAndASingleNode) {
  EXPECT_EQ(border_after(three_by_three(true), {{0, 1}, {0, 3}, {0, 4}}),
            (Segments{{0, 0}, {1, 2}, {1, 3}, {1, 4}, {2, 5}, {3, 4}, {3, 6}, {5, 8}, {6, 7}, {7, 8}}));
}

TEST(NewFaces, LinksAcrossAndBendingLinksOpenNothing) {
  EXPECT_EQ(border_after(three_by_three(true), {{0, 4}, {1, 3}, {0, 2}}), whole);
}

TEST(NewFaces, AChainThatTearsLeavesItsEnds) {
  Scene scene = three_by_three(true);
  scene.lattice[0].rows = 1;
  EXPECT_EQ(border_after(scene, {}), (Segments{{0, 1}, {1, 2}}));
  EXPECT_EQ(border_after(scene, {{1, 2}}), (Segments{{0, 1}, {2, 2}}));
  EXPECT_EQ(border_after(scene, {{0, 1}, {1, 2}}), (Segments{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(NewFaces, SeveralLatticesKeepTheirOwnSegments) {
  Scene scene = three_by_three(true);
  scene.lattice.push_back(scene.lattice[0]);
  scene.lattice[1].origin = {1, 0};
  const Parts parts = make_parts(scene);
  EXPECT_TRUE(std::is_sorted(parts.border.lattice.begin(), parts.border.lattice.end()));
  for (int s = 0; s < parts.border.count(); ++s) {
    EXPECT_EQ(parts.node.lattice[parts.border.a[s]], parts.border.lattice[s]);
    EXPECT_EQ(parts.node.lattice[parts.border.b[s]], parts.border.lattice[s]);
  }
}

}  // namespace
}  // namespace furrow
