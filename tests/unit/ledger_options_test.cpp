// The energy ledger closes with every option of the model.
//
// Where all is smooth, what is left over is the error of the method and shrinks at its order:
//
//   log2(residual(h)/residual(h/2)) -> 2 for pece, 4 for rk4
//
// There nothing touches for the first time, lets go, slips or tears, so that the rule after slip and tight plates change no
// number, but the way through the code. Where contacts begin, slide, pull and end, and links tear, chance decides where in its
// step each of these falls. What is left over need not fall at each halving of the step, but over many of them it does:
//
//   slope of log|residual| over log h, by least squares -> at least 1
//
// A channel that is not booked, or booked twice, leaves the same rest at every step: slope 0.
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

// Its lowest row is fixed.
Lattice standing() {
  Lattice lattice{.rows = 5, .columns = 3, .spacing = 0.1, .node_mass = 5, .material = "soft"};
  lattice.fixed_rows = {0};
  lattice.structural = link_kind(2e4, 20);
  lattice.shear = lattice.bending = link_kind(1e4, 20);
  lattice.auxiliary_points = 0;
  return lattice;
}

// A disc pressed onto the right side of a lattice whose lowest row is fixed and that swings.
Scene pressed_lattice() {
  Scene scene = pressed_row();
  scene.disc.resize(1);
  scene.plate.clear();
  scene.wall.clear();
  Lattice lattice = standing();
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

// A disc flies into a lattice whose lowest row is fixed, and tears it.
Scene torn() {
  Scene scene = thrown();
  scene.disc.resize(1);
  scene.plate.clear();
  scene.wall.clear();
  Lattice lattice = standing();
  lattice.structural.strength = lattice.shear.strength = 60;  // N
  lattice.node = {{.row = 4, .column = 1}};
  scene.lattice = {lattice};
  scene.disc[0].position = {0.305, 0.38};
  scene.disc[0].velocity = {-1.5, -0.3};
  return scene;
}

void closes_roughly(const Scene& scene) {
  constexpr int first = 11, last = 17;  // h = 2^-first s to 2^-last s
  double sum = 0, weight = 0, finest = 0;
  for (int k = first; k <= last; ++k) {
    const Left left = left_over(scene, "pece", std::ldexp(1.0, -k), 0.5);
    EXPECT_NE(left.lost.friction, 0) << "something slides";
    EXPECT_NE(left.lost.contact_viscous, 0) << "something is damped";
    EXPECT_GT(left.lost.lost(), 0.1 * left.turned_over) << "something happens";
    EXPECT_EQ(left.torn > 0, !scene.lattice.empty());
    finest = std::fabs(left.residual) / left.turned_over;
    const double from_mean = k - 0.5 * (first + last);
    sum += from_mean * std::log2(finest);
    weight += from_mean * from_mean;
  }
  EXPECT_GT(-sum / weight, 1) << "the order; of the finest step " << finest << " is left over";
  EXPECT_LT(finest, 1e-5) << "of what was turned over: a channel off by a hundred-thousandth of it is seen";
}

class Ledger : public testing::TestWithParam<Option> {
 protected:
  static Scene with(Scene scene) {
    GetParam().choose(scene);
    return scene;
  }
};

class LedgerOfContacts : public Ledger {};
INSTANTIATE_TEST_SUITE_P(Options, LedgerOfContacts, testing::ValuesIn(of_contacts()));
TEST_P(LedgerOfContacts, ClosesAtTheOrderOfTheMethod) { closes(with(pressed_row())); }
// Not so with the rule `less_viscous` and a stiffness that grows from nothing: ExpectedToFail has it.
TEST_P(LedgerOfContacts, ClosesWhereNothingIsSmooth) {
  Scene scene = with(thrown());
  if (scene.model.after_slip == AfterSlip::less_viscous) make_linear(scene);
  closes_roughly(scene);
}

class LedgerOfLattices : public Ledger {};
INSTANTIATE_TEST_SUITE_P(Options, LedgerOfLattices, testing::ValuesIn(of_lattices()));
TEST_P(LedgerOfLattices, ClosesAtTheOrderOfTheMethod) { closes(with(pressed_lattice())); }
TEST_P(LedgerOfLattices, ClosesWhereNothingIsSmooth) { closes_roughly(with(torn())); }

}  // namespace
}  // namespace furrow
