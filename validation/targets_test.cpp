// How far a value is from its target, and the misfit of several.
#include "validation/calibration/targets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/read.h"
#include "validation/page/observables.h"
#include "validation/studies/observed_run.h"

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

// A plate that starts from rest in 0.04 s and then goes on with 0.5 m/s: v t^2/(2 r) within the ramp, v (t - r/2) after it.
TEST(ObservedRun, SaysHowFarThePlateHasGoneThroughItsRamp) {
  const Scene scene = parse_scene(R"(title = "a plate starts beside a disc"
[time]
end = 0.1
step = 1e-3
[[material]]
name = "soft"
young = 2e5
poisson = 0.3
[[disc]]
position = [-1.0, 1.0]
radius = 0.1
material = "soft"
[[plate]]
left_edge = 0.0
lower_edge = 0.0
width = 0.01
height = 0.1
velocity = [0.3, 0.4]
ramp = 0.04
material = "soft"
[output]
interval = 0.02
frames = [0.02, 0.1]
)",
                                  "ramp");
  const RunRecord run = observed_run(prepare(scene), scene.time);
  const std::vector<double> mm{0, 2.5, 10, 20, 30, 40};
  ASSERT_EQ(run.force.mm.size(), mm.size());
  for (std::size_t k = 0; k < mm.size(); ++k) EXPECT_NEAR(run.force.mm[k], mm[k], 1e-9) << k;
  ASSERT_EQ(run.frames.size(), 2u);
  EXPECT_NEAR(run.frames[0].mm, 2.5, 1e-9);
  EXPECT_NEAR(run.frames[1].mm, 40, 1e-9);
}

}  // namespace
}  // namespace furrow::validation
