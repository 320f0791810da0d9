// Instruction counts hardly vary from run to run: what grows by more than 2 % has become slower, unless somebody says
// why it may.
#pragma once

#include <filesystem>
#include <string>

#include "tracking/counts.h"

namespace furrow::tracking {

// Both return the exit code of track.cpp.
int gate(const std::filesystem::path& accepted, const Build& build);
int accept(const std::filesystem::path& accepted, const Build& build, const std::string& reason);

}  // namespace furrow::tracking
