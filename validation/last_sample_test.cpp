// When samples of a run are due, and what is made of the last one, which is there also where none is due.
#include <gtest/gtest.h>

#include <array>

#include "output/run_files.h"
#include "output/schedule.h"
#include "tests/files.h"
#include "tests/plate_beside_disc.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

// The end lies between two samples.
Scene beside(const std::string& method = "pece") {
  return test::plate_beside_disc("end = 0.055\nmethod = \"" + method + "\"");
}

const std::vector<double> expected{0, 10, 20, 27.5};  // mm: at 0, 0.02, 0.04 and 0.055 s

TEST(LastSample, OfAnObservedRunIsItsEnd) {
  for (const char* method : {"pece", "odeint_dopri5"}) {
    const Scene scene = beside(method);
    const RunRecord run = observed_run(prepare(scene), scene.time);
    ASSERT_EQ(run.force.mm.size(), expected.size()) << method;
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(run.force.mm[k], expected[k], 1e-9) << method;
    EXPECT_EQ(run.force.even(), 3u) << method;
  }
}

TEST(LastSample, OfARunThatIsReadIsTheSame) {
  const furrow::test::OwnDirectory directory;
  const auto place = directory.path() / "run";
  ASSERT_EQ(run_with_files({.scene_file = "s.toml", .scene = beside(), .directory = place}).ended, "finished");
  const RunRecord run = read_run("it", place);
  ASSERT_EQ(run.force.mm.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(run.force.mm[k], expected[k], 1e-9) << k;
  EXPECT_EQ(run.force.even(), 3u);
}

TEST(LastSample, IsSeenByLargestValuesAndCountsInNoMean) {
  RunRecord run;
  run.force = {{0, 10, 20, 20.1}, {1, 2, 3, 90}, {0, 4, 0, 8}, {0, 2, 4, 90}, 3};
  EXPECT_EQ(measure(run, "mean_force").value, 2);
  EXPECT_EQ(measure(run, "mean_fx").value, 2);
  EXPECT_EQ(measure(run, "force_ratio").value, 6.0 / 4);
  EXPECT_EQ(measure(run, "force_free_share").value, 100.0 / 3);
  EXPECT_EQ(measure(run, "largest_force").value, 90);
  EXPECT_EQ(measure(run, "largest_force_at").value, 20.1);
}

TEST(Due, IsTheStepNearestToTheTime) {
  Due due(make_method("pece")->info(), 0.3, 1);
  std::vector<double> taken;
  for (int n = 0; n <= 10; ++n) {
    const double t = 0.3 * n;
    if (due.at(t)) taken.push_back(t), due.take(t);
  }
  ASSERT_EQ(taken.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(taken[k], (std::array{0.0, 0.9, 2.1, 3.0})[k], 1e-12);
}

TEST(Due, OfSeveralInOneStepIsOneSample) {
  Due due(make_method("pece")->info(), 0.5, 0.1);
  due.take(0.5);
  EXPECT_EQ(due.taken(), 8);  // of 0, 0.1 ... 0.7: the next step is nearer to 0.8
  EXPECT_FALSE(due.at(0.5));
}

TEST(Due, ToAMethodThatChoosesItsStepsIsTheTimeItself) {
  Due due(make_method("odeint_dopri5")->info(), 0.3, 1, 10);
  due.take(10);
  EXPECT_FALSE(due.at(10.999));
  EXPECT_EQ(due.stop(10, 20), 11);
  EXPECT_EQ(due.stop(10, 10.5), 10.5);
  EXPECT_TRUE(due.at(11));
}

}  // namespace
}  // namespace furrow::validation
