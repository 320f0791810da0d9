// From a scene as written to a system at t = 0: packings placed, settled, plates at their working depth.
#pragma once

#include <functional>
#include <optional>

#include "run/system.h"
#include "scene/interrupt.h"

namespace furrow {

struct Prepared {
  Scene scene;  // every disc listed, every plate with its lower edge
  System system;
  State y;                        // at t = 0
  std::optional<double> surface;  // m, of the settled discs, if the scene settles
  double settling_time = 0;       // s of model time
  long settling_steps = 0;
  std::vector<std::string> warnings{};  // of the watch over the settling, see validity.h
};

// A scene with a plate at a working depth is settled twice: without such plates, to find the surface, then with all of
// them. Both times by settle.step (or the scene's) and the method pece, plates at rest, links not tearing.
// `progress(model time, greatest speed)` is called now and then; false stops, and prepare throws Interrupted.
// Throws std::runtime_error if the scene does not settle within its limit, Divergence if it blows up or leaves
// the validity of its laws.
using SettleProgress = std::function<bool(double t, double speed)>;
Prepared prepare(const Scene& scene, const SettleProgress& progress = {});

// The same again without settling, from the scene and the surface found before. y and the discrete state are those from
// before the settling; a run that is resumed has later ones.
Prepared prepared_before(const Scene& scene, std::optional<double> surface);

// The parts alone, to count and examine them: nothing has settled, plates at a working depth stand anywhere.
System unsettled(Scene scene);

}  // namespace furrow
