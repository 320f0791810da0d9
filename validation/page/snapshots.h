// The pictures of a run.
#pragma once

#include <string>

#include "validation/page/gnuplot.h"
#include "validation/page/run_record.h"

namespace furrow::validation {

// HTML: a picture for each frame, true to scale and with colour scales that they share. The figures go to `drawings`.
std::string snapshots(const RunRecord& run, Drawings& drawings);

}  // namespace furrow::validation
