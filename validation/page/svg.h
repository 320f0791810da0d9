// gnuplot's drawings as elements of a page.
#pragma once

#include <string>
#include <string_view>

namespace furrow::validation {

// A drawing in a third of its bytes, and the same to the eye: black is the colour of the text around it, groups of
// groups are gone, positions have a tenth of a pixel, marks share their shapes. Ids are prefixed by `name`; titles that
// are gnuplot's own words are dropped, those that a script has given stay, as tips under the pointer.
std::string compacted(std::string_view svg, const std::string& name, const std::string& description);

// The shapes that all drawings of a page share, without a size: to stand once in it.
std::string shared_marks();

}  // namespace furrow::validation
