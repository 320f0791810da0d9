// The path of a scene's key as what it leads to, however it is written.
#pragma once

#include <string>
#include <vector>

namespace furrow::validation {

// "lattice[00].origin.x": lattice, [0], origin, x.
std::vector<std::string> steps_of_path(const std::string& path);

// "lattice[0].origin.x"
std::string text_of_steps(const std::vector<std::string>& steps);

// Whether two paths lead to one key, or one leads into what the other sets.
bool overlap(const std::vector<std::string>& a, const std::vector<std::string>& b);

// A value as set_key takes it: 1 and 1.0 are one, and "wood" with quotes and without.
std::string canonical_value(const std::string& text);

}  // namespace furrow::validation
