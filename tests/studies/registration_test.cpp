// A method from outside comes by itself into the stability atlas, the order certificate and the published problems.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/midpoint_from_outside.h"
#include "verification/studies/amplification.h"
#include "verification/studies/atlas.h"
#include "verification/studies/order_predicted.h"
#include "verification/studies/published_table.h"

namespace furrow::verification {
namespace {

const std::string name = "midpoint_from_outside";

MethodInfo midpoint() {
  test::register_midpoint();
  return make_method(name)->info();
}

// 1 + z + z^2/2: real axis to 2; |.|^2 = 1 + y^4/4 on the imaginary one, a growth of g a step at (8 g)^(1/4).
TEST(RegistrationInStudies, AMethodFromOutsideHasAnEntryInTheAtlas) {
  midpoint();
  const std::vector<AtlasEntry> atlas = atlas_by_theory();
  const auto entry = std::find_if(atlas.begin(), atlas.end(), [](const AtlasEntry& e) {
    return std::find(e.methods.begin(), e.methods.end(), name) != e.methods.end();
  });
  ASSERT_NE(entry, atlas.end());
  EXPECT_EQ(entry->methods, std::vector<std::string>{name}) << "no other method here has this polynomial";
  EXPECT_TRUE(entry->by_eigenvalue);
  EXPECT_NEAR(entry->real_axis, 2, 2e-5);  // the growth that passes moves it by 1e-5
  EXPECT_NEAR(largest_stable_angle(name, 0), std::pow(8 * growth_seen, 0.25),
              1e-3);  // the next term is of relative size y^4
  const std::vector<std::string> outside = methods_outside(atlas);
  EXPECT_EQ(std::count(outside.begin(), outside.end(), name), 0);
}

TEST(RegistrationInStudies, AMethodFromOutsideIsJudgedByTheOrderCertificate) {
  const MethodInfo method = midpoint();
  for (const char* smooth : {"spring", "damped_spring"}) {
    const Problem& p = problem(smooth);
    const Verdict v = verdict(method, p, observe(name, p, quick));
    ASSERT_TRUE(v.predicted);
    EXPECT_EQ(v.predicted->position, 2);
    EXPECT_TRUE(v.position_holds) << v.position.value << ", correlation " << v.position.correlation;
  }
}

TEST(RegistrationInStudies, AMethodFromOutsideIsInTheTableOfPublishedProblems) {
  const MethodInfo method = midpoint();
  const PublishedCell cell = published_cell(method, published_problems().front());
  EXPECT_EQ(cell.cannot, "");
  EXPECT_EQ(cell.least, 2);
  EXPECT_TRUE(cell.holds) << cell.slope.value;
}

// One that claims more than it has is found out by the same functions.
TEST(RegistrationInStudies, AnOrderThatIsClaimedTooHighIsFoundOut) {
  MethodInfo method = midpoint();
  method.order = 3;
  const Problem& p = problem("spring");
  EXPECT_FALSE(verdict(method, p, observe(name, p, quick)).position_holds);
  EXPECT_FALSE(published_cell(method, published_problems().front()).holds);
}

}  // namespace
}  // namespace furrow::verification
