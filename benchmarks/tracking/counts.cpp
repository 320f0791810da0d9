#include "benchmarks/tracking/counts.h"

#include <gnu/libc-version.h>

#include <atomic>
#include <fstream>
#include <future>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "report/measured_process.h"

namespace furrow::benchmarks {
namespace {

namespace fs = std::filesystem;

// The line "totals: N" (callgrind writes "summary:" too, but not in every version).
long instructions_in(const fs::path& file) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("totals: ", 0) == 0) return std::stol(line.substr(8));
  }
  throw std::runtime_error("no totals in " + file.string());
}

bool machine_has(const std::string& feature) {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("flags", 0) == 0) return (line + " ").find(" " + feature + " ") != std::string::npos;
  }
  return false;
}

}  // namespace

void make_beds(const Build& build) { run_measured_well({.words = {build.program, "beds", build.beds}}); }

std::vector<std::string> kernel_names(const Build& build) {
  std::istringstream lines(run_measured_well({.words = {build.program, "list"}}).output);
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) names.push_back(line.substr(0, line.find(' ')));
  return names;
}

Json timed(const Build& build, const std::string& kernel, int repetitions) {
  return Json::parse(
      run_measured_well({.words = {build.program, "run", kernel, build.beds, std::to_string(repetitions)},
                         .errors = build.beds / "errors.txt"})
          .output);
}

Json counted(const Build& build, const std::string& kernel) {
  const fs::path file = build.beds / (kernel + ".callgrind");
  const std::string out = "--callgrind-out-file=" + file.string();
  Json said =
      Json::parse(run_measured_well({.words = {"valgrind", "--quiet", "--tool=callgrind", "--toggle-collect=measured",
                                               "--compress-strings=no", "--compress-pos=no", out, build.program, "run",
                                               kernel, build.beds, "0"},
                                     .errors = build.beds / "errors.txt"})
                      .output);
  said["instructions"] = instructions_in(file);
  return said;
}

Json counted(const Build& build) { return counted(build, kernel_names(build)); }

Json counted(const Build& build, const std::vector<std::string>& names) {
  std::vector<Json> results(names.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k; (k = next++) < names.size();) results[k] = counted(build, names[k]);
  };
  auto other = std::async(std::launch::async, work);
  work();
  other.get();
  Json all;
  for (std::size_t k = 0; k < names.size(); ++k) all[names[k]] = results[k];
  return all;
}

std::string identity(const Json& said) {
  const std::string width = machine_has("avx2") ? "AVX2" : "no AVX2";  // valgrind 3.19 knows none beyond
  std::string valgrind = run_measured_well({.words = {"valgrind", "--version"}}).output;
  valgrind.erase(valgrind.find_last_not_of('\n') + 1);
  return said.at("compiler").get<std::string>() + " " + said.at("flags").get<std::string>() + ", glibc " +
         gnu_get_libc_version() + ", " + valgrind + ", " + width;
}

}  // namespace furrow::benchmarks
