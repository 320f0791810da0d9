// Checks that leave a record. Verdicts, tables and the page are made from the records; nothing is typed by hand.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace furrow::verification {

// How far a result may be from what is expected, and why just so far. There is no tolerance without a reason.
struct Tolerance {
  enum class Kind { relative, absolute };
  Kind kind;
  double value;
  std::string reason;
};

// Of |want|; want must not be zero.
inline Tolerance relative(double value, std::string reason) {
  return {Tolerance::Kind::relative, value, std::move(reason)};
}
inline Tolerance absolute(double value, std::string reason) {
  return {Tolerance::Kind::absolute, value, std::move(reason)};
}
// Not one bit of difference.
inline Tolerance exact(std::string reason) { return {Tolerance::Kind::absolute, 0, std::move(reason)}; }

// Which requirement (an id of verification/requirements) the checks that follow in this test are for. Every test
// states one before its first check.
void requirement(const std::string& id);

// Records name, unit-less or in the unit that `name` ends with ("peak force [N]"), and fails the running test if `got`
// is further from `want` than the tolerance, or either is NaN.
void expect(const std::string& name, double got, double want, const Tolerance& tolerance,
            const char* file = __builtin_FILE(), int line = __builtin_LINE());

// A claim that is true or false; the record shows 1 and what was got.
void expect_true(const std::string& name, bool holds, const std::string& reason, const char* file = __builtin_FILE(),
                 int line = __builtin_LINE());

}  // namespace furrow::verification
