// Paths of SVG, in few bytes: straight lines to a tenth of a pixel, without the points that no eye misses.
#pragma once

#include <string>
#include <string_view>

namespace furrow::validation {

// A number with at most so many digits behind the point, nothing that says nothing: ".5", "-3", "0".
std::string short_number(double value, int digits = 1);

// All numbers of a text, short.
std::string short_numbers(std::string_view text, int digits = 1);

// A path of M, L and Z, else the text with short numbers. Points of long lines that lie within 0.15 of the line through
// their neighbours are left out (Ramer, Douglas and Peucker).
std::string short_path(std::string_view d);

// The points of a polygon, "1,2 3,4 5,6", as such a path.
std::string closed_path(std::string_view points);

}  // namespace furrow::validation
