// Turns the verdict round: exit code 0 only if every test that ran failed by its own expectations, and by all of them.
#include <cstdio>
#include <cstring>

#include "tests/expected_to_fail/expected_to_fail.h"

namespace furrow::test {
namespace {

int expectations = 0, held = 0;  // of the test that runs

std::string property_of(const testing::TestResult& result, const std::string& key) {
  for (int k = 0; k < result.test_property_count(); ++k) {
    if (key == result.GetTestProperty(k).key()) return result.GetTestProperty(k).value();
  }
  return "";
}

int failures_of_another_kind(const testing::TestResult& result) {
  int other = 0;
  for (int k = 0; k < result.total_part_count(); ++k) {
    const testing::TestPartResult& part = result.GetTestPartResult(k);
    if (part.passed()) continue;
    const char* own = std::strstr(part.message(), stated);
    other += !own || (own != part.message() && own[-1] != '\n') ? 1 : 0;
  }
  return other;
}

// Empty if the test failed as it should.
std::string complaint(const testing::TestResult& result) {
  const std::string home = property_of(result, "mended_in");
  if (home.empty()) return "the test does not say where it belongs once its fault is mended (mended_in)";
  if (failures_of_another_kind(result) > 0 || result.Skipped())
    return "it did not come to its expectation: see above what it failed by";
  if (expectations == 0) return "it states nothing that is right (EXPECT_RIGHT)";
  if (held == expectations) return "this fault is mended: move the test to " + home + ", with EXPECT_TRUE";
  if (held > 0) return "a part of this fault is mended: move that part of the test to " + home + ", with EXPECT_TRUE";
  return "";
}

class Judge : public testing::EmptyTestEventListener {
 public:
  void OnTestStart(const testing::TestInfo& /*test*/) override { expectations = held = 0; }
  void OnTestEnd(const testing::TestInfo& test) override {
    const std::string fault = complaint(*test.result());
    ++(fault.empty() ? as_expected : otherwise);
    std::printf("%s.%s %s\n", test.test_suite_name(), test.name(),
                fault.empty() ? "fails, as expected" : ("IS NOT AS EXPECTED: " + fault).c_str());
  }
  int as_expected = 0, otherwise = 0;
};

}  // namespace

bool is_right(bool condition) {
  ++expectations;
  held += condition ? 1 : 0;
  return condition;
}

}  // namespace furrow::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  auto* judge = new furrow::test::Judge;  // the framework deletes it
  testing::UnitTest::GetInstance()->listeners().Append(judge);
  const int failed = RUN_ALL_TESTS();
  if (testing::GTEST_FLAG(list_tests)) return failed;
  return judge->as_expected > 0 && judge->otherwise == 0 && failed != 0 ? 0 : 1;
}
