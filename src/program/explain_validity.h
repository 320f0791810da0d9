// The parts of furrow explain that say what a scene may do to the validity of its laws.
#pragma once

#include "run/prepare.h"

namespace furrow {

// How discs feel the borders of lattices.
void print_borders(const Scene& scene, const Parts& parts);

// Spins that nothing changes.
void print_spins(const Scene& scene);

// The speed from which one part passes through another.
void print_passing(const Parts& parts);

// What the scene allows itself.
void print_allowed(const Scene& scene);

// The step (s) that an impact to come would allow: at the greatest speed of the start, of a fall, or of what its weight
// presses in. Infinity if any.
double print_arrival(const Scene& scene, const Prepared& prepared);

}  // namespace furrow
