// What run.json says of the runs of a page, as far as a reader needs it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/page/page.h"
#include "validation/page/run_record.h"

namespace furrow::validation {

// One row a fact, one column a run; what all runs share fills one cell. `records`: links to the run.json of each, as
// written in the page; empty: there is none beside the page.
std::string runs_table(const std::vector<RunRecord>& runs, const std::vector<std::string>& records, Page& page);

// The link from a page in `page` to the run.json in `run`; empty if it lies outside, or there is none.
std::string link_to_record(const std::filesystem::path& page, const std::filesystem::path& run);

}  // namespace furrow::validation
