// A run that is saved after any of its steps, and goes on in a fresh system, is the same run to the bit: random scenes
// with every option of the model.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "random_scene.h"
#include "scene/read.h"
#include "tests/unit/resumed.h"

namespace furrow {
namespace {

using namespace test;

RC_GTEST_PROP(ResumedRuns, OfRandomScenesAreTheSameBits, ()) {
  const Scene scene = some_scene();
  const Setting setting{.method = *rc::gen::element<std::string>("pece", "ab2", "rk4", "symplectic_euler", "pec"),
                        .end = 4e-3,
                        .step = 1e-4};
  Running running(scene, setting);
  const Course whole = course_of(running, setting, true);
  RC_PRE(whole.saved.size() > 1);
  const std::size_t saved_after = *rc::gen::inRange<std::size_t>(0, whole.saved.size() - 1);
  const Course rest = course_from(scene, setting, whole.saved[saved_after]);
  RC_CLASSIFY(!whole.tears.empty() && whole.tears.front() <= saved_after, "saved after a tear");
  RC_CLASSIFY(!whole.slips.empty() && whole.slips.front() <= saved_after, "saved after a slip");
  RC_ASSERT(rest.end.reason == whole.end.reason);
  RC_ASSERT(rest.bits.size() == whole.bits.size() - saved_after - 1);
  for (std::size_t k = 0; k < rest.bits.size(); ++k) {
    if (rest.bits[k] == whole.bits[saved_after + 1 + k]) continue;
    RC_LOG() << canonical_text(scene);
    RC_FAIL("differs at step " + std::to_string(k) + " after it was saved");
  }
}

}  // namespace
}  // namespace furrow
