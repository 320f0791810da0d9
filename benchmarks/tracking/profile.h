// Where the instructions of the paper's scenes go.
#pragma once

#include <filesystem>

#include "benchmarks/tracking/counts.h"

namespace furrow::benchmarks {

// Runs the scenes under callgrind, sums what each part of the solver takes and writes it to `result`. Exit code of
// track.cpp. Throws std::runtime_error where the parts do not add up to callgrind's own total.
int profile(const Build& build, const std::filesystem::path& result);

}  // namespace furrow::benchmarks
