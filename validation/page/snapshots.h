// The pictures of a run.
#pragma once

#include <filesystem>
#include <string>

#include "page/run_record.h"

namespace furrow {

// HTML: a picture for each frame, true to scale and with colour scales that they share. The SVG files go into `out`.
std::string snapshots(const RunRecord& run, const std::filesystem::path& out);

}  // namespace furrow
