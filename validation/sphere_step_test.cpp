// Spheres are judged at a step that is stable: that is read off the kept study of convergence.
#include <gtest/gtest.h>

#include "tests/files.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/convergence_settled.h"

namespace furrow::validation {
namespace {

const Numbers& kept() {
  static const Numbers numbers = Numbers::read(FURROW_SOURCE_DIR "/reference_data/studies/convergence.json");
  return numbers;
}

// What `furrow run` lets pass, src/run/validity.h.
constexpr double most_made = 0.1;

TEST(StepForSpheres, IsTheCoarsestTriedThatFurrowRunLetsPass) {
  const ConvergencePlan plan = convergence_plan(false);
  for (const ConvergenceCase& c : plan.cases) {
    if (c.reading != Reading::sphere) continue;
    for (const double step : plan.steps)
      EXPECT_EQ(energy_made(kept(), {c, "pece", step}) <= most_made, step <= 1.01 * step_for_spheres)
          << c.name() << " by " << step << " s";
  }
}

TEST(StepForSpheres, IsThatOfTheMembersThatStatementsAreJudgedBy) {
  for (const Member& member : paper_members(false))
    EXPECT_EQ(member.made().time.step, member.reading == Reading::sphere ? step_for_spheres : papers_step)
        << member.key();
}

TEST(Convergence, SaysOfEveryNumberOfSpheresAtThePapersStepThatTheMethodMakesTheEnergy) {
  Shelf shelf(FURROW_SOURCE_DIR "/reference_data/studies");
  const std::string chapter = convergence(shelf).json().dump();
  for (const char* scene : {"scenario_2", "scenario_3"}) {
    const ConvergenceCase c{scene, Reading::sphere};
    const std::string words = instability_words(kept(), {c, "pece", papers_step});
    EXPECT_NE(words, "");
    EXPECT_NE(chapter.find("By " + in_ms(papers_step) + " " + words), std::string::npos) << words;
    const ConvergencePlan plan = convergence_plan(false);
    EXPECT_NE(step_words(kept(), plan, c, "mean_force").find("more than all the energy"), std::string::npos);
  }
  const ConvergenceCase discs{"scenario_2", Reading::disc};
  EXPECT_EQ(instability_words(kept(), {discs, "pece", papers_step}), "");
}

}  // namespace
}  // namespace furrow::validation
