// What moves on the page: films of the runs and of those beside them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/page/film.h"
#include "validation/page/report.h"
#include "validation/page/scene_section.h"

namespace furrow::validation {

using Films = std::map<std::string, std::vector<Film>>;  // by the name of the run
using Besides = std::map<std::string, SceneBeside>;      // the same

// Of the run, and of those beside it that play.
std::vector<Film> films_of(const ReportedRun& reported, const RunRecord& run);

// Adds films under the name "tool".
void add_tool_films(const std::vector<OtherRun>& tools, Films& films);

// The run and the same scene by other steps, those that came to their end.
std::vector<RunByStep> by_step(const ReportedRun& reported, const RunRecord& run);

// The run as if it had been asked for its stills alone: what the page says of pictures is of those that the paper has.
void keep_stills(RunRecord& run, const std::vector<double>& stills);

}  // namespace furrow::validation
