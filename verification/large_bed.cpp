// A bed so large that its forces are summed block by block, those between discs of two blocks last of all. Actions and
// reactions cancel, and it does not matter in which order the discs are stored and their forces summed:
//
//   sum of m a = 0 without weight and walls,   a(mirror image) = mirror image of a, but for round-off
//
// Source: Newton's third law; the curve along which discs are stored (system/place.h) has no mirror symmetry.
#include <algorithm>

#include "kernel/kernel.h"
#include "system/place.h"
#include "verification/check.h"
#include "verification/frozen_scenes.h"

namespace furrow::verification {
namespace {

// Rows of discs that overlap and move at random, three blocks of them, or their image in the y axis. Neither weight nor
// walls.
Scene bed_of_three_blocks(bool mirrored) {
  constexpr int count = 2 * discs_per_block + 807, a_row = 90;
  const double side = mirrored ? -1 : 1;
  Scene scene = case_of(scenes / "scenario_2.toml").scene;
  scene.model.gravity = 0;
  scene.wall.clear();
  scene.plate.clear();
  scene.disc.resize(count);
  for (int place = 0; place < count; ++place) {
    const double phase = 0.7 * place * place;  // rad
    Disc& d = scene.disc[place];
    d = {.position = {side * 0.0195 * (place % a_row), 0.0195 * (place / a_row)}, .radius = 0.01, .material = "common"};
    d.velocity = {side * 0.3 * std::sin(phase), 0.3 * std::cos(1.3 * phase)};
    d.spin = side * 20 * std::sin(2.1 * phase);
  }
  return scene;
}

TEST(LargeBed, SumsItsForcesInAnyOrder) {
  requirement("invariants.large_bed");
  const Scene scene = bed_of_three_blocks(false);
  const int count = static_cast<int>(scene.disc.size());
  System bed(scene), image(bed_of_three_blocks(true));
  const State y = bed.initial_state(), y_image = image.initial_state();
  State rates(y.size()), rates_image(y.size());
  bed.rhs(0, y, rates);
  image.rhs(0, y_image, rates_image);
  expect_true("pairs that reach into another block", kernel_of(bed.solver()).search().contributions > 60,
              "three squares of 64 discs a side; otherwise the test would be of nothing");
  expect_true("the image is stored in another order", bed.parts().disc.number != image.parts().disc.number,
              "otherwise its sums would be the same");
  const std::vector<int> place = places_in(image.parts().disc.number);
  double sum_x = 0, sum_y = 0, size = 0, largest = 0, change = 0, turned = 0, largest_turn = 0;
  for (int i = 0; i < count; ++i) {
    const int other = place[bed.parts().disc.number[i]];
    const double ax = rates[bed.vx_of(i)], ay = rates[bed.vy_of(i)], spin = rates[bed.spin_of(i)];
    sum_x += ax, sum_y += ay, size += std::fabs(ax) + std::fabs(ay);
    largest = std::max({largest, std::fabs(ax), std::fabs(ay)});
    largest_turn = std::max(largest_turn, std::fabs(spin));
    change = std::max(
        {change, std::fabs(ax + rates_image[image.vx_of(other)]), std::fabs(ay - rates_image[image.vy_of(other)])});
    turned = std::max(turned, std::fabs(spin + rates_image[image.spin_of(other)]));
  }
  const Tolerance cancelling = absolute(
      4e-12,
      "equal masses: 9,000 sums of four forces, none of the 36,000 roundings above 1.1e-16 of the sum of all sizes");
  expect("sum of the forces along x, of the sum of their sizes [-]", sum_x / size, 0, cancelling);
  expect("sum of the forces along y, of the sum of their sizes [-]", sum_y / size, 0, cancelling);
  const Tolerance alike = absolute(5e-15,
                                   "the places are the same to the bit; at most eight terms of the largest size, "
                                   "each rounded by 1.1e-16 of at most five times that size");
  expect("largest change of an acceleration, of the largest [-]", change / largest, 0, alike);
  expect("largest change of a spin's rate, of the largest [-]", turned / largest_turn, 0, alike);
  for (const auto& [cause, name] :
       {std::pair(contact_viscous, "viscous"), {friction_work, "friction"}, {rolling_work, "rolling"}}) {
    const double one = rates[bed.ledger_of(cause)], other = rates_image[image.ledger_of(cause)];
    expect_true(std::string(name) + " power is not nothing", std::fabs(one) > 1e-3, "a ratio of nothing says nothing");
    expect(std::string(name) + " power of the image [-]", other / one, 1,
           relative(4e-12, "36,000 terms of one sign, each rounded by at most 1.1e-16 of the sum"));
  }
}

}  // namespace
}  // namespace furrow::verification
