// Who is running: enough to tell one process from any other, before and after.
#pragma once

#include <string>

namespace furrow {

struct ProcessIdentity {
  long pid = 0;
  long start = 0;  // clock ticks after the machine's: pids come again
  std::string host;
  bool operator==(const ProcessIdentity&) const = default;
};

ProcessIdentity this_process();

// Only of processes on this machine it can be known; of others it is supposed.
bool is_alive(const ProcessIdentity& process);

// Now, as 2026-01-31T23:59:59Z.
std::string utc_time();

}  // namespace furrow
