// One key of a scene by its path and its value as text, as a command line gives it.
#pragma once

#include <string>

#include "scene/scene.h"

namespace furrow {

// "time.step" and "1e-4", "disc[0].position" and "[0.0, 0.1]", "disc[0].position.x" and "0.0", "disc[0].material" and
// "soil". Returns what is wrong,
// with the nearest known name for an unknown key; empty if nothing is. The range of the key is not looked at.
std::string set_key(Scene& scene, const std::string& path, const std::string& text);

}  // namespace furrow
