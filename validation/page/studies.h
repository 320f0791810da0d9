// The page's parts about studies: whatever `furrow study` left, shown without knowing what it is about.
#pragma once

#include <filesystem>
#include <string>

#include "validation/page/gnuplot.h"

namespace furrow::validation {

enum class StudyPlace { before_scenes, after_scenes };

// A line of the page's contents for each result, and a section for each; HTML. A result that is missing or cannot be
// used makes none, see missing_evidence. The figures go to `drawings`. Throws std::runtime_error if gnuplot fails.
std::string study_contents(const std::filesystem::path& directory, StudyPlace place);
std::string study_sections(const std::filesystem::path& directory, StudyPlace place, Drawings& drawings);

}  // namespace furrow::validation
