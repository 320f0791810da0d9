// The page's parts about studies: whatever `furrow study` left, shown without knowing what it is about.
#pragma once

#include <filesystem>
#include <string>

namespace furrow {

enum class StudyPlace { before_scenes, after_scenes };

// A line of the page's contents for each result, and a section for each; HTML. A directory without results makes none.
// The figures go into `out`. Throws std::runtime_error if a file is malformed or gnuplot fails.
std::string study_contents(const std::filesystem::path& directory, StudyPlace place);
std::string study_sections(const std::filesystem::path& directory, StudyPlace place, const std::filesystem::path& out);

}  // namespace furrow
