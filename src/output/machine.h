// What machine this is, and its clocks.
#pragma once

#include <ctime>
#include <fstream>
#include <string>

namespace furrow {

inline std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

inline double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
inline double cpu_seconds() { return seconds(CLOCK_THREAD_CPUTIME_ID); }  // of this thread: runs go side by side
inline double wall_seconds() { return seconds(CLOCK_MONOTONIC); }

}  // namespace furrow
