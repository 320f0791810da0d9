// Faults that are known and not mended yet, each as a test that says what is right. Such a test must fail, and by its
// own expectation: then ctest counts it as passed. On the day it holds, or fails by anything else (an exception, a
// scene that is refused, another check), ctest is red; see main.cpp.
#pragma once

#include "tests/command_line/program.h"

namespace furrow::test {

class ExpectedToFail : public Program {
 protected:
  // Where this test belongs once the fault is mended.
  static void mended_in(const std::string& file) { RecordProperty("mended_in", file); }
};

inline constexpr const char* stated = "right would be: ";  // how the failure of an expectation begins

// Whether it holds; counted, so that half a mended fault is seen too.
bool is_right(bool condition);

}  // namespace furrow::test

// EXPECT_RIGHT(condition) << "what is right, and what was found";
#define EXPECT_RIGHT(condition)            \
  GTEST_AMBIGUOUS_ELSE_BLOCKER_            \
  if (furrow::test::is_right(condition)) { \
  } else                                   \
    ADD_FAILURE() << furrow::test::stated
