// From a scene to arrays: links of a lattice by formula, its border, masses, laws and names.
#include "system/parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

Lattice linked_lattice(int rows, int columns) {
  Lattice l = lattice({1, 2}, rows, columns, 0.5);
  l.structural = link_kind(100, 1, 10);
  l.shear = link_kind(200, 2, 20);
  l.bending = link_kind(300, 3, 30);
  return l;
}

Parts parts_of(const Lattice& l) {
  Scene scene = empty_scene();
  scene.lattice = {l};
  return make_parts(scene);
}

long links_of(const Parts& parts, LinkClass kind) {
  return std::count(parts.link.kind.begin(), parts.link.kind.end(), kind);
}

TEST(Links, AreAsManyAsTheFormulaSays) {
  for (const int r : {1, 2, 3, 10}) {
    for (const int c : {1, 2, 3, 7}) {
      const Parts parts = parts_of(linked_lattice(r, c));
      EXPECT_EQ(links_of(parts, LinkClass::structural), r * (c - 1) + c * (r - 1)) << r << " x " << c;
      EXPECT_EQ(links_of(parts, LinkClass::shear), 2 * (r - 1) * (c - 1)) << r << " x " << c;
      EXPECT_EQ(links_of(parts, LinkClass::bending), r * std::max(0, c - 2) + c * std::max(0, r - 2))
          << r << " x " << c;
    }
  }
}

TEST(Links, NoneIsDouble) {
  const Parts parts = parts_of(linked_lattice(4, 5));
  std::set<std::pair<int, int>> seen;
  for (int k = 0; k < parts.link.count(); ++k) {
    EXPECT_LT(parts.link.a[k], parts.link.b[k]);
    EXPECT_TRUE(seen.insert({parts.link.a[k], parts.link.b[k]}).second);
  }
}

TEST(Links, RestAtTheDistanceOfTheirNodes) {
  const Parts parts = parts_of(linked_lattice(4, 3));
  for (int k = 0; k < parts.link.count(); ++k) {
    const int a = parts.link.a[k];
    const int b = parts.link.b[k];
    const double distance = std::hypot(parts.node.x[a] - parts.node.x[b], parts.node.y[a] - parts.node.y[b]);
    EXPECT_NEAR(parts.link.rest[k], distance, 1e-15);
    const LinkClass kind = parts.link.kind[k];
    const double want = kind == LinkClass::structural ? 0.5 : kind == LinkClass::shear ? 0.5 * std::sqrt(2.0) : 1;
    EXPECT_NEAR(parts.link.rest[k], want, 1e-15);
  }
}

TEST(Links, CarryTheNumbersOfTheirKind) {
  const Parts parts = parts_of(linked_lattice(3, 3));
  for (int k = 0; k < parts.link.count(); ++k) {
    const int kind = 1 + static_cast<int>(parts.link.kind[k]);
    EXPECT_EQ(parts.link.stiffness[k], 100 * kind);
    EXPECT_EQ(parts.link.damping[k], kind);
    EXPECT_EQ(parts.link.strength[k], 10 * kind);
  }
}

TEST(Links, OfAKindWithoutStiffnessAndDampingDoNotExist) {
  Lattice l = linked_lattice(3, 3);
  l.shear = link_kind(0, 0);
  l.bending = link_kind(0, 5);
  const Parts parts = parts_of(l);
  EXPECT_EQ(links_of(parts, LinkClass::shear), 0);
  EXPECT_EQ(links_of(parts, LinkClass::bending), 6);
}

TEST(Links, RestLengthIgnoresDisplacedNodes) {
  Lattice l = linked_lattice(1, 2);
  l.node = {node_setting(0, 1, {0.25, 0})};
  const Parts parts = parts_of(l);
  EXPECT_EQ(parts.node.x[1], 1.75);
  EXPECT_EQ(parts.link.rest[0], 0.5);
}

// Twice the area inside the chain of segments; positive: counter-clockwise.
double twice_area(const Parts& parts) {
  double sum = 0;
  for (int s = 0; s < parts.border.count(); ++s) {
    const int a = parts.border.a[s];
    const int b = parts.border.b[s];
    sum += parts.node.x[a] * parts.node.y[b] - parts.node.x[b] * parts.node.y[a];
  }
  return sum;
}

TEST(Border, IsAClosedCounterClockwiseChainAroundTheLattice) {
  for (const auto& [r, c] : {std::pair{2, 2}, {2, 5}, {10, 3}}) {
    const Parts parts = parts_of(linked_lattice(r, c));
    ASSERT_EQ(parts.border.count(), 2 * (r - 1) + 2 * (c - 1));
    for (int s = 0; s < parts.border.count(); ++s) {
      EXPECT_EQ(parts.border.b[s], parts.border.a[(s + 1) % parts.border.count()]);
    }
    EXPECT_NEAR(twice_area(parts), 2 * 0.25 * (r - 1) * (c - 1), 1e-13);
  }
}

TEST(Border, LiesOnStructuralLinks) {
  const Parts parts = parts_of(linked_lattice(4, 3));
  for (int s = 0; s < parts.border.count(); ++s) {
    const int k = parts.border.link[s];
    ASSERT_GE(k, 0);
    EXPECT_EQ(parts.link.kind[k], LinkClass::structural);
    EXPECT_EQ(std::minmax(parts.link.a[k], parts.link.b[k]), std::minmax(parts.border.a[s], parts.border.b[s]));
  }
}

TEST(Border, OfOneRowOrColumnIsTheRowOrColumn) {
  for (const auto& [r, c] : {std::pair{1, 4}, {4, 1}}) {
    const Parts parts = parts_of(linked_lattice(r, c));
    ASSERT_EQ(parts.border.count(), 3);
    for (int s = 0; s < 3; ++s) {
      EXPECT_EQ(parts.border.a[s], s);
      EXPECT_EQ(parts.border.b[s], s + 1);
    }
  }
}

TEST(Border, OfOneNodeIsTheNode) {
  const Parts parts = parts_of(linked_lattice(1, 1));
  ASSERT_EQ(parts.border.count(), 1);
  EXPECT_EQ(parts.border.a[0], 0);
  EXPECT_EQ(parts.border.b[0], 0);
  EXPECT_EQ(parts.border.link[0], -1);
}

TEST(Nodes, LieRowByRowFromTheOrigin) {
  const Parts parts = parts_of(linked_lattice(3, 2));
  ASSERT_EQ(parts.node.count(), 6);
  for (int n = 0; n < 6; ++n) {
    EXPECT_EQ(parts.node.row[n], n / 2);
    EXPECT_EQ(parts.node.column[n], n % 2);
    EXPECT_EQ(parts.node.x[n], 1 + 0.5 * (n % 2));
    const int row = n / 2;
    EXPECT_EQ(parts.node.y[n], 2 + 0.5 * row);
  }
}

TEST(Nodes, OfFixedRowsAndColumnsAreNoBodies) {
  Scene scene = empty_scene();
  scene.disc = {disc({9, 9}, 0.1)};
  Lattice l = linked_lattice(3, 3);
  l.fixed_rows = {0};
  l.fixed_columns = {2};
  scene.lattice = {l};
  const Parts parts = make_parts(scene);
  EXPECT_EQ(parts.node.body, (std::vector<int>{-1, -1, -1, 1, 2, -1, 3, 4, -1}));  // body 0 is the disc
  EXPECT_EQ(parts.free_nodes, 4);
  EXPECT_EQ(parts.bodies(), 5);
}

TEST(Nodes, HaveWeightOnlyIfTheLatticeHas) {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.lattice = {linked_lattice(1, 1), linked_lattice(1, 1)};
  scene.lattice[1].gravity = true;
  EXPECT_EQ(make_parts(scene).node.gravity, (std::vector<double>{0, 9.81}));
}

TEST(Discs, HaveMassAndInertiaOfADisc) {
  Scene scene = empty_scene();
  scene.material[0].density = 500;
  scene.model.disc_depth = 2;
  scene.disc = {disc({0, 0}, 0.1)};
  const Parts parts = make_parts(scene);
  const double mass = 500 * 3.14159265358979323846 * 0.01 * 2;
  EXPECT_NEAR(parts.disc.mass[0], mass, 1e-14 * mass);
  EXPECT_NEAR(parts.disc.inertia[0], mass * 0.005, 1e-14 * mass);
  EXPECT_NEAR(parts.disc.volume[0], mass / 500, 1e-14);
}

TEST(Discs, HaveMassAndInertiaOfASphere) {
  Scene scene = empty_scene();
  scene.material[0].density = 500;
  scene.model.disc_mass = DiscMass::sphere;
  scene.model.disc_depth = 2;  // of no account
  scene.disc = {disc({0, 0}, 0.1)};
  const Parts parts = make_parts(scene);
  const double mass = 500 * 4 * 3.14159265358979323846 * 0.001 / 3;
  EXPECT_NEAR(parts.disc.mass[0], mass, 1e-14 * mass);
  EXPECT_NEAR(parts.disc.inertia[0], mass * 0.004, 1e-14 * mass);
  EXPECT_NEAR(parts.disc.volume[0], mass / 500, 1e-14);
}

TEST(Laws, OfAPairOverrideTheScene) {
  Scene scene = empty_scene();
  scene.material = {elastic_material("a"), elastic_material("b")};
  scene.contact.damping_factor = 0.1;
  scene.contact.friction = 0.2;
  scene.contact.rolling_friction = 0.3;
  ContactPair pair;
  pair.materials = {"b", "a"};
  pair.restitution = std::exp(-3.14159265358979323846);  // beta = sqrt(1/2)
  pair.friction = 0.7;
  scene.contact.pair = {pair};
  const Parts parts = make_parts(scene);
  for (const int index : {parts.law_of(0, 1), parts.law_of(1, 0)}) {
    EXPECT_EQ(parts.law[index].friction, 0.7);
    EXPECT_EQ(parts.law[index].rolling, 0.3);  // not given for the pair
    EXPECT_NEAR(parts.law[index].viscosity, 2 * std::sqrt(5.0 / 6) * std::sqrt(0.5), 1e-15);
  }
  for (const int index : {parts.law_of(0, 0), parts.law_of(1, 1)}) {
    EXPECT_EQ(parts.law[index].friction, 0.2);
    EXPECT_NEAR(parts.law[index].viscosity, 2 * std::sqrt(5.0 / 6) * 0.1, 1e-15);
  }
}

TEST(Laws, ShearModulusMayStandForPoissonsRatio) {
  Scene scene = empty_scene();
  scene.material[0].poisson.reset();
  scene.material[0].young = 2e5;
  scene.material[0].shear = 2e5;  // nu = -1/2
  EXPECT_NEAR(make_parts(scene).law[0].modulus, 2e5 / 1.5, 1e-9);
  EXPECT_NEAR(make_parts(scene).law[0].shear_modulus, 40000, 1e-9);
}

TEST(Walls, NormalBecomesAUnitVector) {
  Scene scene = empty_scene();
  scene.wall = {wall({1, 2}, {30, 40})};
  const Parts parts = make_parts(scene);
  EXPECT_NEAR(parts.wall[0].nx, 0.6, 1e-15);
  EXPECT_NEAR(parts.wall[0].ny, 0.8, 1e-15);
}

TEST(Parts, RefuseAPlateWithoutAHeightAndAnUnknownMaterial) {
  Scene scene = empty_scene();
  scene.plate = {plate({0, 0}, 1, 1)};
  scene.plate[0].lower_edge.reset();
  EXPECT_THROW(make_parts(scene), std::invalid_argument);
  scene = empty_scene();
  scene.disc = {disc({0, 0}, 1)};
  scene.disc[0].material = "cheese";
  EXPECT_THROW(make_parts(scene), std::invalid_argument);
}

TEST(Names, SayWhichBodyNodeAndLink) {
  Scene scene = empty_scene();
  scene.disc = {disc({9, 9}, 0.1), disc({8, 8}, 0.1)};
  Lattice l = linked_lattice(2, 2);
  l.name = "stem";
  l.fixed_rows = {0};
  scene.lattice = {linked_lattice(1, 1), l};
  const Parts parts = make_parts(scene);
  EXPECT_EQ(parts.body_name(1), "disc 1");
  EXPECT_EQ(parts.body_name(2), "node (row 0, column 0) of lattice 0");
  EXPECT_EQ(parts.body_name(4), "node (row 1, column 1) of lattice stem");
  EXPECT_EQ(parts.node_name(1), "node (row 0, column 0) of lattice stem");
  EXPECT_EQ(parts.link_name(0),
            "structural link from node (row 0, column 0) of lattice stem to node (row 0, column 1) of lattice stem");
}

}  // namespace
}  // namespace furrow
