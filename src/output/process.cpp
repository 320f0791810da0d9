#include "output/process.h"

#include <unistd.h>

#include <array>
#include <ctime>
#include <fstream>
#include <sstream>

namespace furrow {
namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

// Field 22 of /proc/PID/stat; 0 if there is no such process. The second is the name, in brackets, with anything in it.
long start_of(long pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  std::getline(file, line);
  std::istringstream fields(line.substr(line.rfind(')') + 1));
  std::string field;
  for (int k = 3; k <= 22; ++k) fields >> field;
  return fields ? std::stol(field) : 0;
}

}  // namespace

ProcessIdentity this_process() { return {getpid(), start_of(getpid()), host_name()}; }

bool is_alive(const ProcessIdentity& process) {
  if (process.host != host_name()) return true;
  return process.start != 0 && process.start == start_of(process.pid);
}

std::string utc_time() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", gmtime_r(&now, &parts));
  return text.data();
}

}  // namespace furrow
