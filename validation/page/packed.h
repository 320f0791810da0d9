// Data within a page, in few bytes.
#pragma once

#include <string>
#include <string_view>

namespace furrow::validation {

// Deflated (RFC 1950) and in base64: what a browser's DecompressionStream("deflate") takes.
std::string packed(std::string_view data);

// An element of a page that holds it; a script finds it by its id.
std::string packed_element(const std::string& id, std::string_view data);

}  // namespace furrow::validation
