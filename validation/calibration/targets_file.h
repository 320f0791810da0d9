// A file of targets as one JSON value, whichever of the two languages it is written in.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace furrow::validation {

// Throws FileError if it cannot be read.
std::string text_in(const std::filesystem::path& file);

// JSON if its name ends so, else TOML. Throws std::invalid_argument with the file and why it is neither: a key that
// stands twice, or values or keys nested too deep, among others.
nlohmann::ordered_json json_in(const std::filesystem::path& file);

}  // namespace furrow::validation
