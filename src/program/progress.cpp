#include "program/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "program/run_summary.h"
#include "scene/interrupt.h"

namespace furrow {
namespace {

constexpr const char* clear_line = "\r\033[K";

std::string first_word(const std::string& text) { return text.substr(0, text.find(' ')); }

}  // namespace

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { end(); }

void Progress::end() {
  const std::scoped_lock lock(mutex_);
  if (drawn_) std::fputs(clear_line, stderr);
  drawn_ = false;
  std::fflush(stderr);
}

void Progress::begin(const std::string& name, const std::string& doing) {
  {
    const std::scoped_lock lock(mutex_);
    last_ = {};
  }
  show(name, doing, 0, 1);
}

bool Progress::show(const std::string& name, const std::string& doing, double done, double total) {
  if (terminal_) {
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    Item& item = items_[name];
    if (first_word(item.doing) != first_word(doing)) item = {doing, 0, now};
    item.doing = doing;
    item.fraction = done / total;
    if (now - last_ >= std::chrono::milliseconds(100)) {
      last_ = now;
      draw();
    }
  }
  return !interrupt_requested();
}

void Progress::say(const std::string& line) {
  constexpr std::size_t columns = 100;
  const std::scoped_lock lock(mutex_);
  const std::string shown = terminal_ ? wrapped(line, columns, 2) : line;
  std::fprintf(stderr, "%s%s\n", drawn_ ? clear_line : "", shown.c_str());
  drawn_ = false;
}

void Progress::draw() {
  std::string line = clear_line;
  for (const auto& [name, item] : items_) {
    std::string bar(16, '.');
    const auto full = static_cast<std::size_t>(item.fraction * static_cast<double>(bar.size()));
    line += name + " " + first_word(item.doing) + " [" + bar.replace(0, full, full, '#') + "] ";
    const double spent = std::chrono::duration<double>(last_ - item.began).count();
    // Settling ends when nothing moves any more, which cannot be foretold: what it waits for is said instead.
    if (item.doing == "running" && item.fraction > 0.01)
      line += std::to_string(std::lround(spent * (1 / item.fraction - 1))) + " s left ";
    line += item.doing.substr(first_word(item.doing).size());
    line += " ";
  }
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace furrow
