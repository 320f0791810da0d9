// The page's part about one run.
#pragma once

#include <filesystem>
#include <string>

#include "page/run_record.h"

namespace furrow {

// HTML; the figures go into `out` as SVG files.
std::string scene_section(const RunRecord& run, const Publication& paper, const std::filesystem::path& out);

// An entry of run.json as HTML.
std::string fact_shown(const RunRecord& run, const std::string& key);

}  // namespace furrow
