// A bed so large that its forces are summed block by block, those between discs of two blocks last of all. Actions and
// reactions cancel, and it does not matter in which order the discs are counted:
//
//   sum of m a = 0 without weight and walls,   a(disc) the same for any numbering but for round-off
//
// Source: Newton's third law.
#include <algorithm>

#include "kernel/kernel.h"
#include "verification/check.h"
#include "verification/frozen_scenes.h"

namespace furrow::verification {
namespace {

// Rows of discs that overlap and move at random, three blocks of them and no two neighbours with neighbouring numbers.
// Neither weight nor walls.
Scene bed_of_three_blocks(bool backwards) {
  constexpr int count = 2 * discs_per_block + 807, a_row = 90, stride = 2521;  // prime to each other
  Scene scene = case_of(scenes / "scenario_2.toml").scene;
  scene.model.gravity = 0;
  scene.wall.clear();
  scene.plate.clear();
  scene.disc.resize(count);
  for (int place = 0; place < count; ++place) {
    const int number = static_cast<int>(static_cast<long>(place) * stride % count);
    const double phase = 0.7 * place * place;  // rad
    Disc& d = scene.disc[backwards ? count - 1 - number : number];
    d = {.position = {0.0195 * (place % a_row), 0.0195 * (place / a_row)}, .radius = 0.01, .material = "common"};
    d.velocity = {0.3 * std::sin(phase), 0.3 * std::cos(1.3 * phase)};
    d.spin = 20 * std::sin(2.1 * phase);
  }
  return scene;
}

TEST(LargeBed, SumsItsForcesInAnyOrder) {
  requirement("invariants.large_bed");
  const Scene scene = bed_of_three_blocks(false);
  const int count = static_cast<int>(scene.disc.size());
  System bed(scene), backwards(bed_of_three_blocks(true));
  State y = bed.initial_state(), y_back = backwards.initial_state();
  State rates(y.size()), rates_back(y.size());
  bed.rhs(0, y, rates);
  backwards.rhs(0, y_back, rates_back);
  expect_true("pairs that reach into another block", kernel_of(bed.solver()).search().contributions > count / 2,
              "otherwise the test would be of nothing");
  double sum_x = 0, sum_y = 0, size = 0, largest = 0, change = 0, turned = 0, largest_turn = 0;
  for (int i = 0; i < count; ++i) {
    const int other = count - 1 - i;
    const double ax = rates[bed.vx_of(i)], ay = rates[bed.vy_of(i)], spin = rates[bed.spin_of(i)];
    sum_x += ax, sum_y += ay, size += std::fabs(ax) + std::fabs(ay);
    largest = std::max({largest, std::fabs(ax), std::fabs(ay)});
    largest_turn = std::max(largest_turn, std::fabs(spin));
    change = std::max({change, std::fabs(ax - rates_back[backwards.vx_of(other)]),
                       std::fabs(ay - rates_back[backwards.vy_of(other)])});
    turned = std::max(turned, std::fabs(spin - rates_back[backwards.spin_of(other)]));
  }
  const Tolerance cancelling = absolute(
      4e-12,
      "equal masses: 9,000 sums of four forces, none of the 36,000 roundings above 1.1e-16 of the sum of all sizes");
  expect("sum of the forces along x, of the sum of their sizes [-]", sum_x / size, 0, cancelling);
  expect("sum of the forces along y, of the sum of their sizes [-]", sum_y / size, 0, cancelling);
  const Tolerance alike = absolute(5e-15,
                                   "the place is the same to the bit; at most eight terms of the largest size, "
                                   "each rounded by 1.1e-16 of at most five times that size");
  expect("largest change of an acceleration, of the largest [-]", change / largest, 0, alike);
  expect("largest change of a spin's rate, of the largest [-]", turned / largest_turn, 0, alike);
  for (const auto& [cause, name] :
       {std::pair(contact_viscous, "viscous"), {friction_work, "friction"}, {rolling_work, "rolling"}}) {
    const double one = rates[bed.ledger_of(cause)], other = rates_back[backwards.ledger_of(cause)];
    expect_true(std::string(name) + " power is not nothing", std::fabs(one) > 1e-3, "a ratio of nothing says nothing");
    expect(std::string(name) + " power, counted backwards [-]", other / one, 1,
           relative(4e-12, "36,000 terms of one sign, each rounded by at most 1.1e-16 of the sum"));
  }
}

}  // namespace
}  // namespace furrow::verification
