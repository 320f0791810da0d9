#include "output/child.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "output/files.h"
#include "output/machine.h"
#include "scene/interrupt.h"

namespace furrow {
namespace {

constexpr int could_not_start = 127;
constexpr timespec between_looks{0, 5'000'000};  // s, ns

// A file in memory: nothing is left over, and no writer waits for a reader.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("furrow", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::runtime_error(std::string("no file in memory: ") + std::strerror(errno));
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }

  void fill(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t n = write(descriptor_, text.data(), text.size());
      if (n < 0 && errno != EINTR) throw std::runtime_error(std::string("no room in memory: ") + std::strerror(errno));
      if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
    }
  }

  long long bytes() const {
    struct stat status {};
    return fstat(descriptor_, &status) == 0 ? status.st_size : 0;
  }

  std::string text() const {
    std::string all;
    std::array<char, 65536> part{};
    while (true) {
      const ssize_t n = pread(descriptor_, part.data(), part.size(), static_cast<off_t>(all.size()));
      if (n == 0) return all;
      if (n < 0 && errno != EINTR) throw std::runtime_error(std::string("memory is lost: ") + std::strerror(errno));
      if (n > 0) all.append(part.data(), static_cast<std::size_t>(n));
    }
  }

 private:
  int descriptor_;
};

// A variable that no other process has, but what this child starts.
std::string new_mark() {
  static std::atomic<long> count{0};
  return "FURROW_CHILD=" + std::to_string(getpid()) + "." + std::to_string(++count) + "." +
         std::to_string(static_cast<long long>(1e6 * wall_seconds()));
}

bool bears(const std::filesystem::path& process, const std::string& mark) {
  std::ifstream stream(process / "environ", std::ios::binary);
  std::string variable;
  while (std::getline(stream, variable, '\0')) {
    if (variable == mark) return true;
  }
  return false;
}

// What it finds may have started more meanwhile; what cannot be killed is waited for no longer than half a second.
void kill_all_that_bear(const std::string& mark) {
  bool found = true;
  for (int look = 0; found && look < 100; ++look) {
    if (look > 0) nanosleep(&between_looks, nullptr);
    found = false;
    std::error_code gone;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", gone)) {
      const std::string name = entry.path().filename();
      if (name.find_first_not_of("0123456789") != std::string::npos || !bears(entry.path(), mark)) continue;
      found = kill(static_cast<pid_t>(std::stol(name)), SIGKILL) == 0 || found;
    }
  }
}

// After fork: only what is safe there.
[[noreturn]] void become(char* const* words, char* const* environment, pid_t parent, int input, int output,
                         int errors) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(could_not_start);
  for (const int ignored : {SIGPIPE, SIGXFSZ}) std::signal(ignored, SIG_DFL);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  fcntl(input, F_SETFD, 0);
  execvpe(words[0], words, environment);
  _exit(could_not_start);
}

// The child and all that it has started.
class Group {
 public:
  Group(pid_t leader, std::string mark) : leader_(leader), mark_(std::move(mark)) { setpgid(leader, leader); }
  ~Group() {
    kill(-leader_, SIGKILL);
    if (!ended_) waitpid(leader_, &status_, 0);
    kill_all_that_bear(mark_);
  }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  bool has_ended() { return ended_ = ended_ || waitpid(leader_, &status_, WNOHANG) == leader_; }
  int code() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_); }

 private:
  pid_t leader_;
  std::string mark_;
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace

ChildEnd run_child(const ChildRequest& request) {
  const std::string name = request.words[0] == "/bin/sh" ? "the command" : request.words[0];
  const MemoryFile input, output, errors;
  input.fill(request.input);
  std::vector<std::string> words = request.words;
  for (std::string& word : words) {
    if (word == "{input}") word = "/dev/fd/" + std::to_string(input.descriptor());
  }
  std::vector<char*> pointers, environment;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::string mark = new_mark();
  for (char** variable = environ; *variable; ++variable) environment.push_back(*variable);
  environment.push_back(mark.data());
  environment.push_back(nullptr);
  const double begun = wall_seconds();
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw std::runtime_error(name + " cannot be started: " + std::strerror(errno));
  if (child == 0)
    become(pointers.data(), environment.data(), parent, input.descriptor(), output.descriptor(), errors.descriptor());
  Group group(child, mark);
  while (!group.has_ended()) {
    throw_if_interrupted();
    if (wall_seconds() - begun > request.limit)
      throw std::runtime_error(name + " has not ended after " + number(request.limit) +
                               " s, its limit, and was stopped");
    if (output.bytes() + errors.bytes() > ChildRequest::most_output)
      throw std::runtime_error(name + " has printed more than " + std::to_string(ChildRequest::most_output >> 20) +
                               " MiB and was stopped");
    nanosleep(&between_looks, nullptr);
  }
  return {group.code(), output.text(), errors.text()};
}

}  // namespace furrow
