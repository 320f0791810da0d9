// One key of a scene by its path and its value as text, as a command line gives it.
#pragma once

#include <string>

#include "scene/scene.h"

namespace furrow {

// "time.step" and "1e-4". Returns what is wrong with the text, empty if nothing; the range of the key is not looked at.
// The path leads through tables, not through lists. Throws std::logic_error if there is no such key.
std::string set_key(Scene& scene, const std::string& path, const std::string& text);

}  // namespace furrow
