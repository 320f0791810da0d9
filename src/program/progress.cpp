#include "program/progress.h"

#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>

namespace furrow {
namespace {

volatile std::sig_atomic_t interrupts = 0;

void note(int signal_number) {
  interrupts = interrupts + 1;
  std::signal(signal_number, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
}

bool was_interrupted() { return interrupts > 0; }

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::show(const std::string& name, const std::string& doing, double done, double total) {
  if (!terminal_) return;
  const std::scoped_lock lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  Item& item = items_[name];
  if (item.doing != doing) item = {doing, 0, now};
  item.fraction = done / total;
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  draw();
}

void Progress::say(const std::string& line) {
  const std::scoped_lock lock(mutex_);
  std::fprintf(stderr, "%s%s\n", drawn_ ? "\r\033[K" : "", line.c_str());
  drawn_ = false;
}

void Progress::draw() {
  std::string line = "\r\033[K";
  for (const auto& [name, item] : items_) {
    constexpr int width = 16;
    const int full = static_cast<int>(item.fraction * width);
    line += name + " " + item.doing + " [" + std::string(static_cast<std::size_t>(full), '#') +
            std::string(static_cast<std::size_t>(width - full), '.') + "] ";
    const double spent = std::chrono::duration<double>(last_ - item.began).count();
    // Settling ends when nothing moves any more, which cannot be foretold.
    if (item.doing == "running" && item.fraction > 0.01) {
      line += std::to_string(std::lround(spent * (1 / item.fraction - 1))) + " s left ";
    }
    line += " ";
  }
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace furrow
