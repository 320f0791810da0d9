// The page's parts about studies: what their chapters make of the numbers that `furrow study` left, and how old these are.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "validation/page/evidence.h"
#include "validation/page/gnuplot.h"

namespace furrow::validation {

enum class StudyPlace { before_scenes, after_scenes };

// What a chapter says (Report::json), without what stands around it; HTML. `old_times`: its times are older than the
// solver.
std::string chapter_html(const nlohmann::ordered_json& chapter, bool old_times, Drawings& drawings);

// A line of the page's contents for each result, and a section for each; HTML. A result that is missing or cannot be
// used makes none, see missing_evidence. The figures go to `drawings`. Throws std::runtime_error if gnuplot fails.
std::string study_contents(const Evidence& evidence, StudyPlace place);
std::string study_sections(const Evidence& evidence, StudyPlace place, Drawings& drawings);

}  // namespace furrow::validation
