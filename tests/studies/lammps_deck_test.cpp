// The deck of the rival: a wall of `granular hertz/material` has, in Debian's LAMMPS (29 Sep 2021, Jan 2022), E* too
// high by 1 + nu and kt = E (2 - nu)(1 + nu)/4 in place of 8 G*. With numbers, `granular hertz KN GAMMA tangential
// mindlin KT ...`, it is right.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

namespace furrow::test {
namespace {

TEST(LammpsDeck, GivesWallsTheirStiffnessesAsNumbers) {
  std::ifstream file(FURROW_SOURCE_DIR "/benchmarks/rivals/lammps.in");
  const std::string deck{std::istreambuf_iterator<char>(file), {}};
  const std::regex wall("\"variable wall string '([^']*)'\"");
  int walls = 0;
  for (auto at = std::sregex_iterator(deck.begin(), deck.end(), wall); at != std::sregex_iterator(); ++at, ++walls)
    EXPECT_NE((*at)[1].str().find("${kn}"), std::string::npos) << (*at)[1];
  EXPECT_GT(walls, 0);
}

}  // namespace
}  // namespace furrow::test
