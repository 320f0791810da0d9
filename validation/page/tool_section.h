// The scene of a tool that bends, beside the same tool driven at all its nodes.
#pragma once

#include <string>
#include <vector>

#include "validation/page/film.h"
#include "validation/page/page.h"
#include "validation/page/report.h"

namespace furrow::validation {

// HTML; empty if there is nothing to play. Throws std::runtime_error if a run has no drive_force.csv or gnuplot fails.
std::string tool_section(const std::vector<OtherRun>& tools, const std::vector<Film>& films, const std::string& number,
                         Page& page);

}  // namespace furrow::validation
