// A scene with the changes from the command line.
#pragma once

#include "program/commands.h"
#include "scene/scene.h"

namespace furrow {

// Throws SceneError for a bad file, std::invalid_argument for a bad change.
Scene requested_scene(const RunOptions& options);

}  // namespace furrow
