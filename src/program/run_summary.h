// How a run ended, in four lines for people.
#pragma once

#include <filesystem>
#include <string>

namespace furrow {

// Of what run.json says; `replaced`: the directory held an earlier run.
std::string run_summary(const std::string& json, const std::filesystem::path& directory, bool replaced);

// A text in lines of at most `width` columns, broken between words; all but the first are indented.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace furrow
