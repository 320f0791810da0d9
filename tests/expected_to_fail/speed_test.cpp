// What takes longer than it need: counted, not timed.
#include "tests/expected_to_fail/expected_to_fail.h"
#include "tests/unit/counting_system.h"

namespace furrow::test {
namespace {

TEST_F(ExpectedToFail, PecEvaluatesLessOftenThanPece) {
  mended_in("tests/unit/methods_test.cpp");
  const double pec = evaluations_a_step("pec"), pece = evaluations_a_step("pece");
  ASSERT_EQ(pece, 2) << "its second one is the jump's";
  EXPECT_RIGHT(pec < pece) << "all contacts less often than " << pece << " times a step; they were evaluated " << pec
                           << " times";
}

TEST_F(ExpectedToFail, VerletTakesTheRatesThatAJumpLeaves) {
  mended_in("tests/unit/methods_test.cpp");
  for (const char* method : {"verlet", "odeint_velocity_verlet"}) {
    const double a_step = evaluations_a_step(method);
    EXPECT_RIGHT(a_step == 1) << method << " evaluates all contacts once a step, in the jump or by itself; it was "
                              << a_step << " times";
  }
}

}  // namespace
}  // namespace furrow::test
