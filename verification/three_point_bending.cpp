// A stem on two supports, pushed by a third plate between them: its stiffness, and the load at which it breaks.
//
//   d = F l^3/(48 EI) + F l/(4 GA), of its middle line against the supports, l between them
//   a link of the edge next to the load sees the moment F l/4 (1 - s/l); it tears at the stress S = M (d/2)/I:
//     F = 4 S I/(d/2)/(l - s)
//
// Source: strength of materials. The forces are found where the stem rests between the three plates.
#include <cmath>

#include "verification/check.h"
#include "verification/pressed_stem.h"

namespace furrow::verification::stem {
namespace {

TEST(ThreePointBending, StemYieldsAsItsRod) {
  requirement("stem.three_points");
  Press press;
  for (const double travel : {1e-6, 1e-5, 3e-5, 1e-4, 2e-4}) press.to(travel);
  const double GA = EA / (2 * (1 + 1.0 / 3));
  expect("bend / force [m/N]", press.bend() / press.force(), std::pow(span, 3) / (48 * EI) + span / (4 * GA),
         relative(2e-3,
                  "the load on one edge squeezes three cells: C d/l, C = 0.0165 as of a clamp, doubled, and "
                  "(slope)^2 = 4e-5"));
}

TEST(ThreePointBending, StemBreaksAtItsStrength) {
  requirement("stem.breaks");
  Press press;
  for (const double travel : {1e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 1.5e-3}) press.to(travel);
  const double expected = 4 * strength * second_moment / (diameter / 2) / (span - s);
  for (double by = 5e-4; by > 5e-6;) {
    Press next = press;
    next.to(press.travel() + by);
    ASSERT_TRUE(next.force() > 0 && next.travel() < 0.006) << "it must break before";
    if (next.tears())
      by /= 2;
    else
      press = next;
  }
  expect(
      "force at the first tear, of the rod's", press.force() / expected, 1,
      absolute(0.01,
               "the bend of 3 mm turns the ends by 0.09: cos 0.09 = 0.996 of the lever arms; the last halving 2e-3"));
}

}  // namespace
}  // namespace furrow::verification::stem
