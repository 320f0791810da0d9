// Scenes in which the kernel once gave other bits than the reference.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "both_solvers.h"

namespace furrow {
namespace {

using test::BothSolvers;

Scene of_one_material() {
  Scene scene;
  scene.material = {{.name = "soft", .young = 1e5, .poisson = 0.25}};
  return scene;
}

Lattice four_columns(int rows) {
  return {.origin = {0, 0}, .rows = rows, .columns = 4, .spacing = 0.02, .node_mass = 0.2, .material = "soft"};
}

// What these tests say of a difference.
TEST(KernelIsReference, ADifferenceIsNamedByItsNumberAndItsContact) {
  Scene scene = of_one_material();
  scene.contact.friction = 0.5;
  scene.disc = {{{0, 0}, 0.01, {}, 0, "soft"}, {{0.019, 0}, 0.01, {}, 0, "soft"}};
  scene.wall = {{"", {0, -0.009}, {0, 1}, "soft"}};
  const System system(scene);
  std::vector<Contact> contacts;
  system.for_each_contact(0, system.initial_state(), [&](const Contact& c) { contacts.push_back(c); });
  ASSERT_EQ(contacts.size(), 3u);
  Contact other = contacts[0];
  other.force.normal = std::nextafter(other.force.normal, 1e300);
  const auto said = [&](const Contact& one, const Contact& two) { return test::difference(system.parts(), one, two); };
  EXPECT_EQ(said(contacts[0], contacts[0]), "");
  EXPECT_EQ(said(contacts[0], other).find("normal force of the disc-disc contact of disc 0 and disc 1: kernel "), 0u);
  EXPECT_EQ(
      said(contacts[1], contacts[2]),
      "the next contact: kernel the disc-wall contact of disc 0 and wall 0, reference the disc-wall contact of disc "
      "1 and wall 0");
  const DiscreteState start = system.discrete_state();
  DiscreteState changed = start;
  std::swap(changed.unused.front(), changed.unused.back());
  EXPECT_EQ(test::difference(start, changed).find("which slots are unused: "), 0u);
  changed = start;
  changed.preparing = true;
  EXPECT_EQ(test::difference(start, changed), "whether the scene is prepared: kernel 0, reference 1");
}

// A node adds up its links in their order, whatever kinds and widths of lattices stand beside it.
TEST(KernelIsReference, WithLatticesOfUnequalWidthAndOneKindOfLink) {
  for (const auto kind : {&Lattice::structural, &Lattice::shear, &Lattice::bending}) {
    Scene scene = of_one_material();
    for (const int columns : {3, 5, 1, 4}) {
      Lattice l;
      l.origin = {0.2 * columns, 0};
      l.rows = 5;
      l.columns = columns;
      l.spacing = 0.02;
      l.node_mass = 0.2;
      l.material = "soft";
      l.*kind = {2000, 1, 3};
      for (int n = 0; n < 5 * columns; ++n)
        l.node.push_back(
            {n / columns, n % columns, {1e-3 * (n * n % 7 - 3), 1e-3 * (n * n % 5 - 2)}, {0.1 * n, 0}, {0.3, 0.1 * n}});
      scene.lattice.push_back(l);
    }
    EXPECT_EQ(BothSolvers(scene).run("pece", 1e-4, 40), "");
  }
}

// No node can roll, whatever the law says of it: a slot of its contacts has one number.
TEST(KernelIsReference, WhereALawOfRollingSpringsMeetsNodesAlone) {
  Scene scene = of_one_material();
  scene.model.rolling = Rolling::spring;
  scene.contact = {.friction = 0.3, .rolling_friction = 0.3};
  scene.wall = {{"", {0, 0}, {0, 1}, "soft"}};
  Lattice l = four_columns(3);
  l.structural = {2000, 1, infinity};
  for (int column = 0; column < 4; ++column)  // the last one comes first, and takes the first slot
    l.node.push_back({0, column, {0, 3e-4 * (4 - column)}, {0.1 * column, -1}, {}});
  scene.lattice = {l};
  BothSolvers both(scene);
  EXPECT_EQ(both.run("pece", 1e-4, 40), "");
  EXPECT_GT(both.contacts(), 100);
}

// A tear lays a face bare that a disc touches already and that no list has: nothing has moved far enough for a new one.
TEST(KernelIsReference, WhereATearLaysBareWhatADiscTouches) {
  Scene scene = of_one_material();
  scene.model.new_faces = true;
  scene.disc = {{{-0.012, 0.03}, 0.033, {}, 0, "soft"}};  // deep in the cell behind the link that tears
  Lattice l = four_columns(4);
  l.structural = {2000, 1, 1};
  l.node.push_back({2, 0, {}, {0, 1}, {}});  // at this speed its link holds for five steps
  scene.lattice = {l};
  BothSolvers both(scene);
  EXPECT_EQ(both.run("pece", 1e-4, 12), "");
  const DiscreteState end = both.kernel().discrete_state();
  EXPECT_FALSE(end.torn.empty());
  EXPECT_NE(end.border, System(scene).discrete_state().border) << "no face came";
}

// A contact that was long apart and touches at a stage of a step, but neither before nor after it, keeps its slot: the
// method may remember its slip.
TEST(KernelIsReference, WhereDiscsTouchWithinAStepAlone) {
  Scene scene = of_one_material();
  scene.contact.friction = 0.5;
  const double radius = 0.01, step = 1e-4, speed = 400;  // m, s, m/s
  scene.disc = {{{0, 0}, radius, {}, 0, "soft"}, {{0, 0.0199}, radius, {speed, 0}, 0, "soft"}};
  System system(scene);
  const auto method = make_method("rk4");
  const int other = 1;
  State y = system.initial_state();
  jump(system, *method, 0, y);
  ASSERT_EQ(system.discrete_state().held.size(), 1u);
  y[system.x_of(other)] = -0.5 * speed * step - 1;
  for (std::uint32_t n = 1; n < quiet_jumps; ++n) jump(system, *method, 0, y);
  y[system.x_of(other)] = -0.5 * speed * step;  // halfway it touches
  const DiscreteState before = system.discrete_state();
  ASSERT_EQ(before.jumps - before.held.at(0).near_at, quiet_jumps - 1);
  BothSolvers both(scene);
  both.start_from(y, before);
  EXPECT_EQ(both.run("rk4", step, 1), "");
  EXPECT_EQ(both.kernel().discrete_state().held.size(), 1u);
}

}  // namespace
}  // namespace furrow
