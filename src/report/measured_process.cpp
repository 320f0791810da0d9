#include "report/measured_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace furrow {
namespace {

constexpr int could_not_start = 127;

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

[[noreturn]] void become(const MeasuredCommand& command, int output) {
  std::vector<char*> words;
  for (const std::string& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  for (const std::string& entry : command.environment) putenv(const_cast<char*>(entry.c_str()));
  const int errors = open(command.errors.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  if (command.directory.empty() || chdir(command.directory.c_str()) == 0) execvp(words[0], words.data());
  _exit(could_not_start);
}

}  // namespace

MeasuredEnd run_measured(const MeasuredCommand& command) {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(std::strerror(errno));
  if (child == 0) become(command, pipe_ends[1]);
  close(pipe_ends[1]);
  MeasuredEnd ran;
  std::array<char, 4096> part{};
  int lost = 0;
  for (ssize_t n = 0; lost == 0 && (n = read(pipe_ends[0], part.data(), part.size())) != 0;) {
    if (n < 0 && errno != EINTR) lost = errno;
    if (n > 0) ran.output.append(part.data(), static_cast<std::size_t>(n));
  }
  close(pipe_ends[0]);
  int status = 0;
  rusage used{};
  while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  ran.real_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ran.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  if (lost != 0) throw std::runtime_error("cannot read what " + command.words[0] + " says: " + std::strerror(lost));
  if (ran.status == could_not_start) throw std::runtime_error("cannot start " + command.words[0]);
  return ran;
}

MeasuredEnd run_measured_well(const MeasuredCommand& command) {
  MeasuredEnd ran = run_measured(command);
  if (ran.status == 0) return ran;
  std::string text;
  for (const std::string& word : command.words) text += word + " ";
  throw std::runtime_error(text + "ended with " + std::to_string(ran.status) + "; see " + command.errors.string());
}

}  // namespace furrow
