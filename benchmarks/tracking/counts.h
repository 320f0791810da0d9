// What the kernels take: instructions, counted by callgrind, and CPU seconds.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace furrow::benchmarks {

using Json = nlohmann::ordered_json;

// One build of track_kernels and the beds that it starts from.
struct Build {
  std::filesystem::path program, beds;
};

void make_beds(const Build& build);
std::vector<std::string> kernel_names(const Build& build);

// What `track_kernels run` says.
Json timed(const Build& build, const std::string& kernel, int repetitions);

// The same without times, and with "instructions"; callgrind's file is BEDS/KERNEL.callgrind.
Json counted(const Build& build, const std::string& kernel);

// All kernels, or those named, two at a time.
Json counted(const Build& build);
Json counted(const Build& build, const std::vector<std::string>& names);

// What else the counts depend on: compiler, flags, C library, valgrind, vector width.
std::string identity(const Json& said_by_kernel);

}  // namespace furrow::benchmarks
