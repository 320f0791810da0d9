// A measured force curve from a CSV file: displacement and force, a point a line.
#pragma once

#include <filesystem>

#include "validation/calibration/targets.h"

namespace furrow::validation {

// Sets displacements (mm, rising from 0 or more), forces (N) and `heading`. The heading names both columns with their units; lines
// may end with CR and LF, and empty ones are passed over. Throws FileError, std::invalid_argument with file and line.
void read_curve(MeasuredCurve& curve, const std::filesystem::path& file);

}  // namespace furrow::validation
