// Drawings as files of their own beside a page. Titles are what browsers show where the pointer rests and screen readers say.
#pragma once

#include <string>
#include <string_view>

namespace furrow::validation {

// Whether the title of a part says something: gnuplot also writes its own count, or the words of its command.
bool says_something(std::string_view title);

// The drawing of gnuplot with `what` it shows as its title, `name` in the ids of its parts, and a margin, since gnuplot sets
// words closer to the edge than their font may need; titles of parts that say nothing are left out. what: plain text.
std::string as_file(std::string_view drawing, const std::string& name, const std::string& what);

}  // namespace furrow::validation
