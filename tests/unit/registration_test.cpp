// A method from outside is a method like any other: in the catalogue, by its name, in a run.
#include <gtest/gtest.h>

#include <algorithm>

#include "midpoint_from_outside.h"
#include "oscillator.h"
#include "run/run.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

TEST(Registration, AMethodFromOutsideIsInTheCatalogueAndIsMadeByItsName) {
  register_midpoint();
  const auto& all = method_catalogue();
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const auto& m) { return m.name == "midpoint_from_outside"; }), 1);
  EXPECT_EQ(make_method("midpoint_from_outside")->info().order, 2);
}

TEST(Registration, ANameIsTakenOnce) {
  register_midpoint();
  EXPECT_THROW(register_method(midpoint_entry()), std::invalid_argument);
  EXPECT_THROW(register_method({make_method("pece")->info(), midpoint_entry().make}), std::invalid_argument);
}

TEST(Registration, AMethodFromOutsideCarriesASceneWithItsOrder) {
  register_midpoint();
  const auto error = [](double h) {
    const auto method = make_method("midpoint_from_outside");
    const Oscillator system(1, 0);
    State y{1, 0};
    const long steps = std::lround(1 / h);
    for (long n = 0; n < steps; ++n) method->step(system, static_cast<double>(n) * h, y, h);
    return std::fabs(y[0] - std::cos(1.0));
  };
  // Order 2 with the next term of relative size h: within 2 % at h = 0.01.
  EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), 2, 0.02);

  System system(busy_scene());
  State y = system.initial_state();
  const auto method = make_method("midpoint_from_outside");
  const RunEnd end = run(system, *method, y, {.start = 0, .end = 0.01, .step = 1e-4, .stop = {}},
                         [](double, const State&, const JumpReport&) { return true; });
  EXPECT_EQ(end.ending, Ending::finished) << end.reason;
  EXPECT_EQ(end.steps, 100);
}

// The paper's method stands first, own ones before others.
TEST(Registration, TheCatalogueIsInOrder) {
  const auto& all = method_catalogue();
  ASSERT_GT(all.size(), 20u);
  EXPECT_EQ(all.front().name, "pece");
  const auto first_other = std::find_if(all.begin(), all.end(), [](const auto& m) { return m.family != "own"; });
  EXPECT_GT(first_other - all.begin(), 8);
}

}  // namespace
}  // namespace furrow
