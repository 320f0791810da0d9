// What a run did to the validity of its laws: run.json's "validity" in words.
#pragma once

#include <string>
#include <vector>

#include "validation/page/page.h"
#include "validation/page/run_record.h"

namespace furrow::validation {

// A table as HTML.
std::string validity_part(const RunRecord& run, Page& page);

// A table of all runs, in Markdown.
std::string validity_table(const std::vector<RunRecord>& runs);

}  // namespace furrow::validation
