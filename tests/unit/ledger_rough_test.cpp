// The energy ledger closes where nothing is smooth: contacts begin, slide, pull and end, links tear. Where in its step each
// of these falls is chance, so what is left over need not fall at each halving of the step, but over many of them it does:
//
//   slope of log|residual| over log h, by least squares -> at least 1
//
// A channel that is not booked, or booked twice, leaves the same rest at every step: slope 0.
#include <gtest/gtest.h>

#include <cmath>

#include "ledger_scenes.h"

namespace furrow {
namespace {

using namespace test;

constexpr double end = 0.5;  // s

// A disc flies into a lattice whose lowest row is fixed, and tears it.
Scene torn() {
  Scene scene = thrown();
  scene.disc.resize(1);
  scene.plate.clear();
  scene.wall.clear();
  Lattice lattice{.rows = 5, .columns = 3, .spacing = 0.1, .node_mass = 5, .material = "soft"};
  lattice.fixed_rows = {0};
  lattice.structural = link_kind(2e4, 20);
  lattice.shear = lattice.bending = link_kind(1e4, 20);
  lattice.structural.strength = lattice.shear.strength = 60;  // N
  lattice.auxiliary_points = 0;
  lattice.node = {{.row = 4, .column = 1}};
  scene.lattice = {lattice};
  scene.disc[0].position = {0.305, 0.38};
  scene.disc[0].velocity = {-1.5, -0.3};
  return scene;
}

void closes(const Scene& scene) {
  constexpr int first = 11, last = 17;  // h = 2^-first s to 2^-last s
  double sum = 0, weight = 0, finest = 0;
  for (int k = first; k <= last; ++k) {
    const Left left = left_over(scene, "pece", std::ldexp(1.0, -k), end);
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

class RoughLedgerOfContacts : public testing::TestWithParam<Option> {};
INSTANTIATE_TEST_SUITE_P(Options, RoughLedgerOfContacts, testing::ValuesIn(of_contacts()));
// Not so with the rule `less_viscous` and a stiffness that grows from nothing: ExpectedToFail has it.
TEST_P(RoughLedgerOfContacts, Closes) {
  Scene scene = thrown();
  GetParam().choose(scene);
  if (scene.model.after_slip == AfterSlip::less_viscous) make_linear(scene);
  closes(scene);
}

class RoughLedgerOfLattices : public testing::TestWithParam<Option> {};
INSTANTIATE_TEST_SUITE_P(Options, RoughLedgerOfLattices, testing::ValuesIn(of_lattices()));
TEST_P(RoughLedgerOfLattices, Closes) {
  Scene scene = torn();
  GetParam().choose(scene);
  closes(scene);
}

}  // namespace
}  // namespace furrow
