// The energy ledger closes with every option of the model: what is left over is the error of the method and shrinks at its
// order.
//
//   order observed between h and h/2: log2(residual(h)/residual(h/2)) -> 2 for pece, 4 for rk4
//
// In the stretch that is run nothing touches for the first time, lets go, slips or tears: there no method keeps its order.
// So the rule after slip and tight plates change no number here, but the way through the code.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "ledger_scenes.h"

namespace furrow {
namespace {

using namespace test;

// A wall, two discs and a plate in a row, all pressed together; they move, turn and rub without slipping.
Scene pressed_row() {
  constexpr double radius = 0.1, overlap = 0.002;  // m
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.1;
  scene.contact.friction = 50;
  scene.contact.rolling_friction = 0.2;
  scene.model.rolling_smoothing = 1;
  scene.wall = {wall({0, 0}, {1, 0})};
  scene.disc = {disc({radius - overlap, 0}, radius, {-0.003, 0.01}, 0.05),
                disc({3 * radius - 2 * overlap, 0.001}, radius, {0.002, -0.008}, -0.1)};
  scene.plate = {plate({4 * radius - 3 * overlap, -1}, 1, 2, {-0.01, 0.004})};
  return scene;
}

// A disc pressed onto the right side of a lattice whose lowest row is fixed and that swings.
Scene pressed_lattice() {
  Scene scene = pressed_row();
  scene.disc.resize(1);
  scene.plate.clear();
  scene.wall.clear();
  Lattice lattice{.rows = 5, .columns = 3, .spacing = 0.1, .node_mass = 5, .material = "soft"};
  lattice.fixed_rows = {0};
  lattice.structural = link_kind(2e4, 20);
  lattice.shear = lattice.bending = link_kind(1e4, 20);
  lattice.auxiliary_points = 0;
  lattice.node = {{.row = 4, .column = 1, .velocity = {0.02, -0.01}}};
  scene.lattice = {lattice};
  scene.disc[0].position = {0.298, 0.24};
  return scene;
}

void closes(const Scene& scene) {
  for (const auto& [method, order, coarse] : {std::tuple{"pece", 2.0, 0x1p-13}, {"rk4", 4.0, 0x1p-11}}) {
    constexpr double end = 0x1p-4;  // s
    const Left at[2] = {left_over(scene, method, coarse, end), left_over(scene, method, coarse / 2, end)};
    EXPECT_EQ(at[0].torn + at[1].torn, 0);
    EXPECT_GT(at[0].turned_over, 1e-4) << "something happens";
    EXPECT_NEAR(std::log2(at[0].residual / at[1].residual), order, 0.3)
        << method << ": the next term of the series: omega h of the lattice is at most 0.1; residuals "
        << at[0].residual << ", " << at[1].residual;
  }
}

class LedgerOfContacts : public testing::TestWithParam<Option> {};
INSTANTIATE_TEST_SUITE_P(Options, LedgerOfContacts, testing::ValuesIn(of_contacts()));
TEST_P(LedgerOfContacts, ClosesAtTheOrderOfTheMethod) {
  Scene scene = pressed_row();
  GetParam().choose(scene);
  closes(scene);
}

class LedgerOfLattices : public testing::TestWithParam<Option> {};
INSTANTIATE_TEST_SUITE_P(Options, LedgerOfLattices, testing::ValuesIn(of_lattices()));
TEST_P(LedgerOfLattices, ClosesAtTheOrderOfTheMethod) {
  Scene scene = pressed_lattice();
  GetParam().choose(scene);
  closes(scene);
}

}  // namespace
}  // namespace furrow
