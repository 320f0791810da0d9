// All that a scene is warned of before it runs, what its method has no use for included.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace furrow {

std::vector<std::string> warnings_before(const Scene& scene);

}  // namespace furrow
