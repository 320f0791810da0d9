// What those whom furrow is compared with do not do as they should.
#include <regex>

#include "tests/expected_to_fail/expected_to_fail.h"

namespace furrow::test {
namespace {

// A wall of `granular hertz/material` has, in Debian's LAMMPS (29 Sep 2021, Jan 2022), E* too high by 1 + nu and
// kt = E (2 - nu)(1 + nu)/4 in place of 8 G*. With numbers, `granular hertz KN GAMMA tangential mindlin KT ...`, it is
// right.
TEST_F(ExpectedToFail, WallsOfLammpsAreGivenTheirStiffnessesAsNumbers) {
  mended_in("validation/process_test.cpp");
  const std::string deck = text_of(FURROW_SOURCE_DIR "/benchmarks/rivals/lammps.in");
  const std::regex variable("\"variable model string '([a-z/]+) "), wall("\"variable wall string 'granular (.*)'\"");
  std::smatch model, walls;
  ASSERT_TRUE(std::regex_search(deck, model, variable)) << "the model of the pairs";
  ASSERT_TRUE(std::regex_search(deck, walls, wall)) << "that of the walls";
  const std::string law = walls[1] == "${model}" ? model[1] : walls[1].str().substr(0, walls[1].str().find(' '));
  EXPECT_RIGHT(law == "hertz") << "a wall is `granular hertz` with numbers; the deck says `granular " << law << "`";
}

}  // namespace
}  // namespace furrow::test
