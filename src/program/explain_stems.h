// What furrow explain says of lattices as beams.
#pragma once

#include "scene/scene.h"

namespace furrow {

void print_stems(const Scene& scene);

}  // namespace furrow
