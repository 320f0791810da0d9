// Instruction counts hardly vary from run to run: what grows by more than 2 % has become slower, unless somebody says
// why it may.
#pragma once

#include <filesystem>
#include <string>

#include "benchmarks/tracking/counts.h"

namespace furrow::benchmarks {

constexpr int good = 0, failed = 1;

// Kernel by kernel; good only if there is one, each has a partner on the other side, and what is compared is an answer
// or a count. Says what is not.
int check_answers(const Json& accepted, const Json& results);
int check_counts(const Json& accepted, const Json& results);

// Both return the exit code of track.cpp.
int gate(const std::filesystem::path& accepted, const Build& build);
int accept(const std::filesystem::path& accepted, const Build& build, const std::string& reason);

}  // namespace furrow::benchmarks
