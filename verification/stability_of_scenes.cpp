// Whole scenes break at the step that their spectrum and the method's amplification factor give.
//
//   e' = J e  where the scene stands;  h is stable if no eigenvalue of M(h J) is larger than one
//
// J comes from the solver's right-hand side by differences (report/linearise.h), M from the formula of the method
// (studies/amplification.cpp).
#include <cmath>
#include <string>

#include "report/cases.h"
#include "scene/wording.h"
#include "verification/check.h"
#include "verification/studies/blow_up.h"
#include "verification/studies/scene_stability.h"

namespace furrow::verification {
namespace {

TEST(StabilityLimits, ScenesBreakWhereTheirSpectrumSays) {
  requirement("stability.scenes");
  const char* const why = "1 % on either side: friction and clipping shift what has grown ten-thousandfold";
  for (const auto& [file, t] : {std::pair("single_spring", 0.0), {"cantilever", 0.0}, {"scenario_1", 0.03}}) {
    const Standing s = standing_at(scene_file(file), t);
    for (const char* method : {"pece", "pec", "pecece", "ab2", "symplectic_euler", "verlet", "rk4"}) {
      const double limit = predicted_step(s, method);
      const std::string at = std::string(file) + ", " + method + ", step [s] ";
      expect_true(at + shortest(0.99 * limit) + ": what deviates does not grow", !grows(s, method, 0.99 * limit), why);
      expect_true(at + shortest(1.01 * limit) + ": what deviates grows", grows(s, method, 1.01 * limit), why);
    }
  }
}

// The modes of a spring are known: the whole way from the right-hand side to the step, without the solver's advice.
TEST(StabilityLimits, SpringSceneHasTheEigenvaluesOfItsSpring) {
  requirement("stability.scenes");
  const Standing s = standing_at(scene_file("single_spring"), 0);
  const double omega = std::sqrt(500.0 / 5), rate = 5.0 / 5;  // rad/s, 1/s: k/m and c/m of the scene
  const auto differences = relative(1e-6, "central differences of 1e-9 m on a stretch of 1e-2 m");
  expect("fastest motion, real part [1/s]", s.fastest.real(), -rate / 2, differences);
  expect("fastest motion, imaginary part [1/s]", std::fabs(s.fastest.imag()),
         std::sqrt(omega * omega - rate * rate / 4), differences);
}

}  // namespace
}  // namespace furrow::verification
