#include "run/prepare.h"

#include <algorithm>
#include <cmath>

#include "run/observe.h"
#include "run/run.h"
#include "scene/packing.h"
#include "scene/read.h"
#include "scene/wording.h"
#include "system/floating_point.h"

namespace furrow {
namespace {

constexpr long settling_looked_at_every = 100;  // steps, or more often
constexpr double looks_while_held = 10;         // at least
constexpr double first_look = 0.1;              // s: discs that start at rest have begun to fall by then

struct Settled {
  System system;
  State y;
  double time;  // s
  long steps;
  std::vector<std::string> warnings;
};

// What is watched while a scene settles. A bed is judged from the start of the run on: while it settles, discs with
// little damping may pass through each other without ending anything.
Scene watched_while_settling(Scene scene, const std::string& method, double step) {
  scene.time.method = method;
  scene.time.step = step;
  if (!scene.allow) scene.allow.emplace();
  scene.allow->overlap = infinity;
  return scene;
}

// The greatest overlap while it settled, where that is more than the scene allows.
std::string overlap_warning(const Validity& validity, const Scene& placed) {
  Watched overlap = validity.watches()[static_cast<std::size_t>(WatchKind::overlap)];
  overlap.allowed = placed.allow ? placed.allow->overlap : std::nullopt;
  if (overlap.verdict() < Verdict::warned) return {};
  Sentence text;
  text.precision(3);
  text << "while settling, at t = " << overlap.time << " s the overlap is " << overlap.worst
       << " of the smaller radius (" << overlap.where << ")";
  return text.str();
}

Settled settle(const Scene& placed, const SettleProgress& progress) {
  Settled result{System(placed), {}, 0, 0, {}};
  System& system = result.system;
  system.prepare(true);
  result.y = system.initial_state();
  const auto method = make_method("pece");
  const double step = placed.settle->step.value_or(placed.time.step);
  const Scene watched = watched_while_settling(placed, method->info().name, step);
  Validity validity(system, watched,
                    [&](const std::string& text) { result.warnings.push_back("while settling, " + text); });
  const RunPlan plan{.start = 0, .end = placed.settle->limit, .step = step, .stop = {}, .validity = &validity};
  long steps = 0;
  bool interrupted = false;
  double speed = 0;
  double slow_since = 0;
  const double hold = std::max(placed.settle->hold, first_look);
  const long every = std::clamp(std::lround(hold / (looks_while_held * step)), 1L, settling_looked_at_every);
  const RunEnd end = run(system, *method, result.y, plan, [&](double t, const State& y, const JumpReport&) {
    if (++steps % every != 0) return true;
    speed = greatest_speed(system, y, placed.settle->loose.value_or(0));
    interrupted = progress && !progress(t, speed);
    if (speed > placed.settle->speed) slow_since = t;
    return !interrupted && t - slow_since < hold;
  });
  if (interrupted) throw Interrupted("interrupted while settling");
  validity.conclude();
  if (std::string warning = overlap_warning(validity, placed); !warning.empty())
    result.warnings.push_back(std::move(warning));
  Sentence text;
  if (end.ending == Ending::diverged || end.ending == Ending::invalid) {
    text << "while settling, " << (end.ending == Ending::diverged ? "at t = " + shortest(end.time) + " s: " : "")
         << end.reason;
    throw Divergence(text.str());
  }
  if (end.ending == Ending::finished) {
    text << "not settled after " << placed.settle->limit << " s: the fastest body"
         << (placed.settle->loose ? " that is not loose" : "") << " moves at " << speed << " m/s, settle.speed is "
         << placed.settle->speed << " m/s, for " << hold
         << " s; raise settle.limit, settle.speed or settle.loose, or shorten settle.step";
    for (const std::string& warning : result.warnings) text << "; " << warning;
    throw Divergence(text.str());
  }
  result.time = end.time;
  result.steps = end.steps;
  return result;
}

// The plates at a working depth have a place now.
void refuse_bad_start(const Scene& scene) {
  for (const Problem& p : start_problems(scene))
    throw std::invalid_argument("with its plates at their working depths: " + p.path + ": " + p.message);
}

// To their working depths.
void lower_plates(Scene& scene, double surface) {
  for (Plate& p : scene.plate) {
    if (!p.working_depth) continue;
    p.lower_edge = surface - *p.working_depth;
    p.working_depth.reset();
  }
}

}  // namespace

System unsettled(Scene scene) {
  scene.settle.reset();
  for (Plate& p : scene.plate) p.lower_edge = p.lower_edge.value_or(0);
  return System(place_packings(scene));
}

Prepared prepared_before(const Scene& scene, std::optional<double> surface) {
  Scene ready = scene;
  if (surface) lower_plates(ready, *surface);
  ready = place_packings(ready);
  System system(ready);
  State y = system.initial_state();
  return {std::move(ready), std::move(system), std::move(y), surface, 0, 0, {}};
}

Prepared prepare(const Scene& scene, const SettleProgress& progress) {
  const DefaultFloatingPoint environment;
  if (!scene.settle) return prepared_before(scene, {});
  Scene ready = scene;
  const auto needs_surface = [](const Plate& p) { return p.working_depth.has_value(); };
  Prepared result{{}, System(Scene{}), {}, {}, 0, 0, {}};
  if (std::any_of(ready.plate.begin(), ready.plate.end(), needs_surface)) {
    Scene without = ready;
    std::erase_if(without.plate, needs_surface);
    const Settled bed = settle(place_packings(without), progress);
    result.surface = surface_height(bed.system, bed.y);
    result.settling_steps = bed.steps;
    lower_plates(ready, *result.surface);
  }
  if (result.surface) refuse_bad_start(ready);
  result.scene = place_packings(ready);
  Settled bed = settle(result.scene, progress);
  bed.system.prepare(false);
  if (!result.surface) result.surface = surface_height(bed.system, bed.y);
  result.system = std::move(bed.system);
  result.y = std::move(bed.y);
  result.settling_time = bed.time;
  result.warnings = std::move(bed.warnings);
  result.settling_steps += bed.steps;
  if (result.system.keeps_ledger()) {
    std::fill(result.y.end() - ledger_entries, result.y.end(), 0.0);
  }
  return result;
}

}  // namespace furrow
