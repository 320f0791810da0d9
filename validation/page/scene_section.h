// The page's part about one run.
#pragma once

#include <string>

#include "validation/page/gnuplot.h"
#include "validation/page/run_record.h"

namespace furrow::validation {

// HTML; the figures go to `drawings`.
std::string scene_section(const RunRecord& run, const Publication& paper, Drawings& drawings);

// An entry of run.json as HTML.
std::string fact_shown(const RunRecord& run, const std::string& key);

}  // namespace furrow::validation
