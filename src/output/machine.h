// What machine this is, and its clocks.
#pragma once

#include <ctime>
#include <fstream>
#include <istream>
#include <map>
#include <string>

namespace furrow {

// "AMD EPYC (family 25, model 17)": virtual machines hide all but the brand in the name. Of a text like /proc/cpuinfo;
// "unknown" if it names no processor.
inline std::string processor_name(std::istream& info) {
  std::map<std::string, std::string> first;  // of the first processor, by key
  for (std::string line; std::getline(info, line) && !line.empty();) {
    const auto colon = line.find(':');
    if (colon == std::string::npos || colon + 2 > line.size()) continue;
    first[line.substr(0, line.find_last_not_of(" \t", colon - 1) + 1)] = line.substr(colon + 2);
  }
  if (!first.contains("model name")) return "unknown";
  if (!first.contains("cpu family") || !first.contains("model")) return first["model name"];
  return first["model name"] + " (family " + first["cpu family"] + ", model " + first["model"] + ")";
}
inline std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  return processor_name(info);
}

inline double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
// Of this thread, since runs go side by side; of the whole process for a run that shares its steps among threads.
inline double cpu_seconds(bool with_other_threads = false) {
  return seconds(with_other_threads ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_THREAD_CPUTIME_ID);
}
inline double wall_seconds() { return seconds(CLOCK_MONOTONIC); }

}  // namespace furrow
