// The page's part about one run.
#pragma once

#include <string>

#include "validation/page/page.h"
#include "validation/page/run_record.h"

namespace furrow::validation {

// HTML; the figures go to the page. `player`: HTML of what moves, may be empty.
std::string scene_section(const RunRecord& run, const Publication& paper, const std::string& number,
                          const std::string& player, Page& page);

// An entry of run.json as HTML.
std::string fact_shown(const RunRecord& run, const std::string& key);

}  // namespace furrow::validation
