// What `scripts/mutants --out` has left, on the page: small random edits of the source, and how many the tests notice.
#pragma once

#include <filesystem>
#include <string>

#include "validation/page/page.h"

namespace furrow::validation {

// What is wrong with the file; empty if it can be shown.
std::string unusable_mutants(const std::filesystem::path& file);

// "90 % of 400 random edits"; empty if there are none.
std::string mutants_in_short(const std::filesystem::path& file);

// HTML; empty if none were asked for.
std::string mutants_part(const std::filesystem::path& file, Page& page);

}  // namespace furrow::validation
