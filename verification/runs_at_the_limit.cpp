// Whole scenes run just below the step limit that their spectrum gives, and fail above it; a run says why.
//
//   e' = J e  where the scene stands;  h is stable if no eigenvalue of M(h J) is larger than one
//
// J and M as in stability_of_scenes.cpp.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "output/run_files.h"
#include "report/cases.h"
#include "scene/wording.h"
#include "verification/check.h"
#include "verification/studies/blow_up.h"
#include "verification/studies/scene_stability.h"

namespace furrow::verification {
namespace {

struct Sides {
  std::string scene;
  double at, end;  // s: the limit is that of this moment; the run ends then
  double above;    // of the limit, where it must fail
  std::string culprit, why;
};
const char* const soon =
    "what grows throws bodies out, or shows a hundred times the energy that the run was ever given";
const char* const bounded =
    "clipping and friction bound what grows: the scene chatters, as the paper's own second scene does, and fails where "
    "a node passes through the plate in a step, or the bed no longer comes to rest";
const Sides sides[] = {
    {"single_spring", 0, 100, 1.03, "link from node", soon},
    {"cantilever", 0, 1, 1.03, "link from node", soon},
    {"resting disc", 0, 20, 1.1, "contact of disc 0 and wall floor",
     "a contact that opens is softer: a little above the limit the disc hops on and on in one orbit"},
    {"scenario_1", 0.03, 1.2, 4.5, "contact of node", bounded},
    {"scenario_2", 0, 0.05, 4, "disc ", bounded},
    {"scenario_3", 0, 0.05, 4, "disc ", bounded},
};

TEST(StabilityLimits, RunsHoldBelowTheLimitAndAreCaughtAboveIt) {
  requirement("stability.caught");
  const std::filesystem::path out =
      std::filesystem::temp_directory_path() / ("furrow_stability_sides_" + std::to_string(getpid()));
  for (const Sides& side : sides) {
    Scene scene = side.scene == "resting disc" ? contact_oscillation(0).scene : scene_file(side.scene);
    scene.output.energy = true;
    scene.output.frames.clear();
    // Near its limit a method swings: what grows without bound is the question here, not what the laws answer for.
    scene.allow = Allow{.energy_made = 100,
                        .energy_lost = 100,
                        .overlap = 100,
                        .behind_walls = true,
                        .through_plates = true,
                        .through_lattices = true};
    const double limit = predicted_step(standing_at(scene, side.at), "pece");
    scene.time.end = side.end;
    const auto ran = [&](double step) {
      scene.time.step = step;
      scene.output.interval = std::max(scene.output.interval, 10 * step);
      return run_with_files({.scene_file = side.scene,
                             .scene = scene,
                             .directory = out,
                             .progress = [](const std::string&, double, double) { return true; },
                             .warn = [](const std::string&) {}});
    };
    const RunOutcome below = ran(0.98 * limit);
    expect_true(side.scene + " at 0.98 of the predicted limit finishes", below.ended == "finished",
                "2 %: the limit is known to half of that " + below.reason);
    const RunOutcome above = ran(side.above * limit);
    expect_true(side.scene + " at " + shortest(side.above) + " of the predicted limit diverges",
                above.ended == "diverged" || above.ended == "invalid", side.why);
    expect_true(side.scene + " names what drives it: " + side.culprit,
                above.reason.find(side.culprit) != std::string::npos, above.reason);
  }
  std::filesystem::remove_all(out);
}

}  // namespace
}  // namespace furrow::verification
