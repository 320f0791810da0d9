// The order of the sums, as system/order.h says it to the reference and to the kernel.
#include "system/order.h"

#include <gtest/gtest.h>

#include "reference/reference.h"
#include "run/system.h"

namespace furrow {
namespace {

TEST(OrderOfSums, BlocksHoldEveryDiscOnce) {
  for (const int discs : {1, 4095, 4096, 4097, 3 * 4096}) {
    int next = 0;
    for (int k = 0; k < blocks_of(discs); ++k) {
      const auto [first, last] = discs_of_block(k, discs);
      EXPECT_EQ(first, next);
      EXPECT_GT(last, first);
      EXPECT_EQ(block_of(first), k);
      EXPECT_EQ(block_of(last - 1), k);
      next = last;
    }
    EXPECT_EQ(next, discs);
  }
}

// The kernel sorts its lists by comes_before().
TEST(OrderOfSums, ReferenceVisitsThePairsInTheirOrder) {
  Scene s;
  s.material = {{.name = "any", .young = 1e5, .poisson = 0.25}};
  for (const double x : {0.0, 0.1, 0.2}) s.disc.push_back({{x, 1}, 0.01, {}, 0, "any"});
  s.wall = {{"", {0, 0}, {0, 1}, "any"}, {"", {0, 0}, {1, 0}, "any"}};
  s.plate.resize(2);
  for (Plate& p : s.plate) p.material = "any", p.lower_edge = 0;
  s.lattice.resize(2);
  for (Lattice& l : s.lattice) l.material = "any", l.rows = 3, l.columns = 2, l.structural = {1, 1};
  const System system(s);
  std::vector<ContactId> pairs;
  reference::for_each_pair(system.parts(), [&](const ContactId& pair) { pairs.push_back(pair); });
  EXPECT_EQ(pairs.size(), 3u + 3 * (2 + 2 + 2) + 12 * (2 + 2));
  for (std::size_t k = 1; k < pairs.size(); ++k) EXPECT_TRUE(comes_before(pairs[k - 1], pairs[k])) << "pair " << k;
}

TEST(OrderOfSums, BlocksAreJoinedInTurn) {
  std::vector<double> sums{1, 1e16, -1e16};  // the 1 is lost: not so from the other end
  join_blocks(sums, [](double& all, double one) { all += one; });
  EXPECT_EQ(sums[0], 0);
}

}  // namespace
}  // namespace furrow
