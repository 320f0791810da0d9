// One test of each kind that must make the program of the expected failures red, and one that must not. Run by `check`.
#include <cstdlib>
#include <stdexcept>

#include "tests/expected_to_fail/expected_to_fail.h"

namespace furrow::test {
namespace {

TEST_F(ExpectedToFail, Fails) {
  mended_in("HOME");
  EXPECT_RIGHT(false) << "this";
}

TEST_F(ExpectedToFail, IsMended) {
  mended_in("HOME");
  EXPECT_RIGHT(true) << "this";
}

TEST_F(ExpectedToFail, IsHalfMended) {
  mended_in("HOME");
  EXPECT_RIGHT(false) << "this";
  EXPECT_RIGHT(true) << "that";
}

TEST_F(ExpectedToFail, FailsByAnotherCheck) {
  mended_in("HOME");
  EXPECT_RIGHT(false) << "this";
  EXPECT_EQ(1, 2) << "a sentence in which right would be: this";
}

TEST_F(ExpectedToFail, Throws) {
  mended_in("HOME");
  throw std::runtime_error("a scene that is refused");
}

TEST_F(ExpectedToFail, ThrowsAfterItsExpectation) {
  mended_in("HOME");
  EXPECT_RIGHT(false) << "this";
  throw std::runtime_error("a scene that is refused");
}

TEST_F(ExpectedToFail, Crashes) {
  mended_in("HOME");
  EXPECT_RIGHT(false) << "this";
  std::abort();
}

TEST_F(ExpectedToFail, IsSkipped) {
  mended_in("HOME");
  EXPECT_RIGHT(false) << "this";
  GTEST_SKIP();
}

TEST_F(ExpectedToFail, StatesNothing) { mended_in("HOME"); }

TEST_F(ExpectedToFail, HasNoHome) { EXPECT_RIGHT(false) << "this"; }

}  // namespace
}  // namespace furrow::test
