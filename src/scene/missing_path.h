// What to say of a file or a directory that is not where it was looked for.
#pragma once

#include <filesystem>
#include <string>

namespace furrow {

enum class PathKind { file, directory };

// `; did you mean "validation/scenes/scenario_1.toml"?`, with the nearest path of that kind that there is; else which
// part of the path is not there, or what stands beside it. Begins with "; " and is never empty.
std::string instead_of(const std::filesystem::path& missing, PathKind kind);

}  // namespace furrow
