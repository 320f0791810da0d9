// Results that a later one may replace, in a directory that is not the program's own.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace furrow {

// Throws FileError unless nothing stands at `file`, or a file of which is_one(text) is true. `what` names such a
// result: "a golden output".
void refuse_what_is_not(const std::string& what, const std::filesystem::path& file,
                        const std::function<bool(const std::string& text)>& is_one);

}  // namespace furrow
