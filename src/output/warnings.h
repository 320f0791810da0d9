// All that a scene is warned of before it runs, what its method has no use for included.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace furrow {

std::vector<std::string> warnings_before(const Scene& scene);

// What only the scene with its bed settled and its plates at their working depths is warned of, of these plates.
std::vector<std::string> warnings_of_lowered_plates(const Scene& asked, const Scene& placed);

}  // namespace furrow
