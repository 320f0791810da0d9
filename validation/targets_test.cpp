// How far a value is from its target, and the misfit of several.
#include "validation/calibration/targets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "validation/page/observables.h"

namespace furrow::validation {
namespace {

TEST(Residual, IsNothingWhereALimitIsKept) {
  CalibrationTarget t;
  t.value = {10, 20};
  t.tolerance = 2;
  const auto of = [&t](Relation relation, const Json& value) {
    t.relation = relation;
    return residuals(t, value, 7).at(0);
  };
  EXPECT_EQ(of(Relation::equals, 14.0), 2);
  EXPECT_EQ(of(Relation::equals, 6.0), -2);
  EXPECT_EQ(of(Relation::below, 6.0), 0);
  EXPECT_EQ(of(Relation::below, 14.0), 2);
  EXPECT_EQ(of(Relation::above, 14.0), 0);
  EXPECT_EQ(of(Relation::above, 6.0), -2);
  EXPECT_EQ(of(Relation::between, 15.0), 0);
  EXPECT_EQ(of(Relation::between, 24.0), 2);
  EXPECT_EQ(of(Relation::equals, "not by the end"), 7) << "what does not happen misses by the stated number";
  EXPECT_EQ(of(Relation::equals, Json()), 7);
}

// One target of two cannot be met: by squares it rules the misfit, bounded it counts at most once.
TEST(Misfit, IsAtMostOneWhereTheLossIsBounded) {
  Targets two;
  two.all.resize(2);
  two.all[0].value = two.all[1].value = {0, 0};
  const Json values = Json::array({100.0, 0.0});
  EXPECT_NEAR(misfit(two, values), 100 / std::sqrt(2), 1e-12);
  two.bounded = true;
  EXPECT_NEAR(misfit(two, values), std::sqrt(0.5 * 1e4 / (1e4 + 1)), 1e-12);
}

TEST(Observables, AreAllKnownByTheirNames) {
  RunRecord run;
  run.force = {{0, 1, 2}, {1, 2, 1}, {0, 0, 0}, {1, 2, 1}};
  for (const std::string& name : observable_names()) EXPECT_NO_THROW(measure(run, name)) << name;
  EXPECT_THROW(measure(run, "none"), std::invalid_argument);
}

}  // namespace
}  // namespace furrow::validation
