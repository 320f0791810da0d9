// The pictures of a run.
#pragma once

#include <string>

#include "validation/page/page.h"
#include "validation/page/run_record.h"

namespace furrow::validation {

// HTML: a picture for each frame, true to scale and with colour scales that they share. The figures go to the page.
std::string snapshots(const RunRecord& run, Page& page);

}  // namespace furrow::validation
