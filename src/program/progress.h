// Progress of one or more runs on one line of standard error, if that is a terminal.
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace furrow {

class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Says at once what is begun, before anything is known of how long it takes.
  void begin(const std::string& name, const std::string& doing);

  // False once an interrupt was requested. Safe to call from several threads.
  bool show(const std::string& name, const std::string& doing, double done, double total);

  // Nothing of it stays on the terminal.
  void end();

  // Prints a whole line to standard error without damage to the progress line.
  void say(const std::string& line);

 private:
  using Clock = std::chrono::steady_clock;
  struct Item {
    std::string doing;
    double fraction = 0;
    Clock::time_point began;
  };
  void draw();

  std::mutex mutex_;
  bool terminal_;
  bool drawn_ = false;
  std::map<std::string, Item> items_;
  Clock::time_point last_{};
};

}  // namespace furrow
