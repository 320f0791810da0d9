// An accepted step: what is watched of it.
#pragma once

#include "run/system.h"

namespace furrow {

// Squares of the greatest of all bodies. What is not a number counts as nothing.
struct Motion {
  double moved_squared = 0;  // m^2, between the two states
  double speed_squared = 0;  // m^2/s^2, at the end
};

// A step of h that ended at t.
struct Step {
  double t, h;  // s
  const State &before, &after;
  Motion motion;
};

Step step_of(const System& system, double t, double h, const State& before, const State& after);

}  // namespace furrow
