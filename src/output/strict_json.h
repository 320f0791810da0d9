// JSON that anybody may have written or changed.
#pragma once

#include <istream>
#include <nlohmann/json.hpp>
#include <string_view>

namespace furrow {

// Throws std::invalid_argument that says why: it is no JSON (UTF-8, one value and nothing after it), has a key twice, of
// which one would hide the other, or is nested deeper than 100, which would end the program.
nlohmann::ordered_json strict_json(std::string_view text);

// The same, without a reason: is_discarded() in place of an error.
nlohmann::ordered_json json_or_discarded(std::string_view text);
nlohmann::ordered_json json_or_discarded(std::istream& stream);

}  // namespace furrow
