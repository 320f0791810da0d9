// The program from outside: how it is started, and what it leaves.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/files.h"

namespace furrow::test {

namespace fs = std::filesystem;

struct Result {
  int code;
  std::string out, err;
};

inline int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status); }

// Nothing here waits for a time to pass: only for what must come, with a limit that means "never".
inline bool comes_true(const std::function<bool()>& condition) {
  const auto never = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > never) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

inline std::size_t lines_of(const fs::path& file) {
  const std::string text = text_of(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

// The program while it runs.
class Process {
 public:
  // A shell makes itself into the program, so that this is its process.
  Process(const fs::path& directory, const std::string& command) {
    const std::string line = "cd '" + directory.string() + "' && exec " + command;
    pid_ = fork();
    if (pid_ == 0) {
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
  }
  ~Process() {
    if (ended_) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t pid() const { return pid_; }
  void send(int signal_number) const { kill(pid_, signal_number); }
  bool has_ended() {
    ended_ = ended_ || wait4(pid_, &status_, WNOHANG, &used_) == pid_;
    return ended_;
  }
  // Exit code, or minus the signal that ended it.
  int code() {
    if (!comes_true([&] { return has_ended(); })) return -1000;
    return code_of(status_);
  }

  // It has installed a handler for this signal; the shell that becomes it has one of its own.
  bool hears(int signal_number) const {
    const std::string status = text_of("/proc/" + std::to_string(pid_) + "/status");
    const std::size_t at = status.find("SigCgt:");
    return at != std::string::npos && status.starts_with("Name:\tfurrow\n") &&
           (std::stoull(status.substr(at + 8), nullptr, 16) >> (signal_number - 1) & 1U) != 0;
  }

  // CPU time so far, s: it has begun to work. Of one that has ended, all that it took.
  double cpu_seconds() const {
    if (ended_) return seconds(used_.ru_utime) + seconds(used_.ru_stime);
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

 private:
  static double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }

  pid_t pid_ = -1;
  int status_ = 0;
  rusage used_{};
  bool ended_ = false;
};

class Program : public testing::Test {
 protected:
  // The program runs in a directory of its own; `before` goes in front of it ("ulimit -f 8;").
  Result furrow(const std::string& arguments, const std::string& before = "") const {
    const std::string command = "cd '" + directory_.string() + "' && " + before + " '" FURROW_PROGRAM "' " + arguments +
                                " >stdout.txt 2>stderr.txt </dev/null";
    const int status = std::system(command.c_str());
    return {code_of(status), text_of(directory_ / "stdout.txt"), text_of(directory_ / "stderr.txt")};
  }

  // What it said last.
  std::string out() const { return text("stdout.txt"); }
  std::string err() const { return text("stderr.txt"); }

  // The same with streams of its own: "run x.toml >/dev/full".
  int code_of_line(const std::string& arguments, const std::string& before = "") const {
    return code_of(
        std::system(("cd '" + directory_.string() + "' && " + before + " '" FURROW_PROGRAM "' " + arguments).c_str()));
  }

  // Started, not waited for.
  std::string started(const std::string& arguments, const std::string& input = "/dev/null") const {
    return "'" FURROW_PROGRAM "' " + arguments + " >stdout.txt 2>stderr.txt <" + input;
  }

  static std::string scene(const std::string& name) {
    return "'" FURROW_SOURCE_DIR "/validation/scenes/" + name + ".toml'";
  }
  // A packing `height` high (m) that falls for the time `end` (s).
  static std::string bed_on_two_threads(int discs, const std::string& end, const std::string& height) {
    return "title = \"A bed\"\n[time]\nend = " + end + "\nstep = 1e-4\n[search]\nthreads = 2\n" +
           "[[material]]\nname = \"common\"\ndensity = 1000.0\nyoung = 2e6\npoisson = 0.2\n" +
           "[[packing]]\ncount = " + std::to_string(discs) + "\nradius_min = 0.01\nradius_max = 0.01\n" +
           "lower_left = [0.0, 0.0]\nupper_right = [3.0, " + height + "]\nmaterial = \"common\"\nseed = 1\n";
  }
  static std::string bad_scene(const std::string& name) {
    return "'" FURROW_SOURCE_DIR "/tests/bad_input/" + name + ".toml'";
  }

  std::vector<std::string> files(const std::string& below = ".") const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(directory_ / below)) {
      const std::string name = entry.path().filename();
      if (entry.is_regular_file() && name != "stdout.txt" && name != "stderr.txt") names.push_back(name);
    }
    return names;
  }
  // Name and text of every file of a run but for what differs from run to run by itself: the marker, times of the
  // clock.
  std::map<std::string, std::string> bits(const std::string& below) const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(directory_ / below)) {
      const std::string name = fs::relative(entry.path(), directory_ / below);
      if (!entry.is_regular_file() || name == ".furrow.json") continue;
      found[name] = text_of(entry.path());
      if (name == "run.json") found[name] = nlohmann::json::parse(found[name]).value("state_hash", "none");
    }
    return found;
  }
  bool has(const std::string& file) const { return fs::exists(directory_ / file); }
  std::string text(const std::string& file) const { return text_of(directory_ / file); }
  void put(const std::string& file, const std::string& text = "mine") const {
    fs::create_directories((directory_ / file).parent_path());
    std::ofstream(directory_ / file) << text;
  }

  const OwnDirectory own_;
  const fs::path directory_ = own_.path();
};

}  // namespace furrow::test
