// What `scripts/judge --keep` has left, on the page: verification cases by engines, and what each engine does instead.
#pragma once

#include <filesystem>
#include <string>

#include "validation/page/page.h"

namespace furrow::validation {

// What is wrong with the file; empty if it can be shown.
std::string unusable_judgements(const std::filesystem::path& file);

// "LAMMPS 2022: 20 of 57 right, ...", of the engines that are not furrow's, as HTML.
std::string judged_in_short(const std::filesystem::path& file);

// HTML.
std::string judgements_section(const std::filesystem::path& file, const std::string& number, Page& page);

}  // namespace furrow::validation
