// Places the discs of a packing at random.
#pragma once

#include "scene/scene.h"

namespace furrow {

// The scene with every packing turned into single discs, in the order of the packings, none of which overlaps another
// disc, a wall, a plate with a known lower edge, or a lattice. Random sequential addition; the same seed gives the same
// discs. Throws std::runtime_error if a rectangle has no room for its discs.
Scene place_packings(const Scene& scene);

}  // namespace furrow
