// The page's part about one run.
#pragma once

#include <string>

#include "validation/page/page.h"
#include "validation/page/run_record.h"
#include "validation/page/scene_figures.h"

namespace furrow::validation {

// What stands beside a run; each may be empty.
struct SceneBeside {
  std::string player{};              // HTML of what moves
  ForceBand band{};                  // of other packings
  std::vector<RunByStep> by_step{};  // the run itself among them
};

// HTML; the figures go to the page.
std::string scene_section(const RunRecord& run, const Publication& paper, const std::string& number,
                          const SceneBeside& beside, Page& page);

// An entry of run.json as HTML.
std::string fact_shown(const RunRecord& run, const std::string& key);

}  // namespace furrow::validation
