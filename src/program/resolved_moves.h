// Whether the places of a scene's parts resolve the way of one step.
#pragma once

#include <string>
#include <utility>

#include "scene/scene.h"

namespace furrow {

// The key of the first part that a fixed step moves by less than its place can tell, and what to do. Empty if there is
// none.
std::pair<std::string, std::string> unresolved_move(const Scene& scene);

}  // namespace furrow
