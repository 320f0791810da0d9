// A request to stop, such as a signal: set by a handler, checked wherever work takes long. A program that embeds furrow
// and never sets it is never stopped.
#pragma once

#include <atomic>
#include <stdexcept>
#include <string>

namespace furrow {

class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// May be set and read in a signal handler.
struct InterruptRequest {
  std::atomic<int> signal = 0;          // its number; 0: none
  std::atomic<bool> is_urgent = false;  // some time has gone by since
};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);
inline InterruptRequest interrupt_request;

inline bool interrupt_requested() { return interrupt_request.signal.load(std::memory_order_relaxed) != 0; }

// "interrupted by SIGTERM"
std::string interrupt_words();

// For use between steps, tasks or attempts, where all data are consistent.
inline void throw_if_interrupted() {
  if (interrupt_requested()) throw Interrupted(interrupt_words());
}

// For use inside work that is better finished, such as a step, but may take long.
inline void throw_if_interrupt_is_urgent() {
  if (interrupt_request.is_urgent.load(std::memory_order_relaxed)) throw Interrupted(interrupt_words());
}

}  // namespace furrow
