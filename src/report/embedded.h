// Text files that are part of the library: figure scripts, page templates and published reference data.
#pragma once

#include <string_view>
#include <vector>

namespace furrow {

// The text of a file, known by its path in the project, such as "validation/figures/plate_force.gp".
// Throws std::out_of_range if there is no such file.
std::string_view embedded(std::string_view name);

// The names of all that begin with this.
std::vector<std::string_view> embedded_files(std::string_view folder);

}  // namespace furrow
