#include "program/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "scene/interrupt.h"

namespace furrow {
namespace {

constexpr const char* clear_line = "\r\033[K";

}  // namespace

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (drawn_) std::fputs(clear_line, stderr);
}

bool Progress::show(const std::string& name, const std::string& doing, double done, double total) {
  if (terminal_) {
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    Item& item = items_[name];
    if (item.doing != doing) item = {doing, 0, now};
    item.fraction = done / total;
    if (now - last_ >= std::chrono::milliseconds(100)) {
      last_ = now;
      draw();
    }
  }
  return !interrupt_requested();
}

void Progress::say(const std::string& line) {
  const std::scoped_lock lock(mutex_);
  std::fprintf(stderr, "%s%s\n", drawn_ ? clear_line : "", line.c_str());
  drawn_ = false;
}

void Progress::draw() {
  std::string line = clear_line;
  for (const auto& [name, item] : items_) {
    std::string bar(16, '.');
    const auto full = static_cast<std::size_t>(item.fraction * static_cast<double>(bar.size()));
    line += name + " " + item.doing + " [" + bar.replace(0, full, full, '#') + "] ";
    const double spent = std::chrono::duration<double>(last_ - item.began).count();
    // Settling ends when nothing moves any more, which cannot be foretold.
    if (item.doing == "running" && item.fraction > 0.01)
      line += std::to_string(std::lround(spent * (1 / item.fraction - 1))) + " s left ";
    line += " ";
  }
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace furrow
