// Runs a system from one time to another and says how that ended.
#pragma once

#include <functional>
#include <string>

#include "methods/method.h"
#include "run/events.h"
#include "run/validity.h"

namespace furrow {

enum class Ending { finished, stopped, diverged, invalid };

std::string to_string(Ending ending);  // "finished", "interrupted", "diverged", "invalid"

struct RunEnd {
  Ending ending = Ending::finished;
  std::string reason;  // of a divergence or invalidity: what, where, and what to do
  double time = 0;     // s, of the last good state
  long steps = 0;
  long events = 0;             // located, with a step that ends there
  long event_evaluations = 0;  // of the right-hand side, for that, beside the method's
  bool cut = false;            // stopped inside of a step: y is where it began, the method's history is of no use
};

// Where a run stands between two steps. With the state, the discrete state and the method's history it continues the
// run, to the same bits.
struct RunPoint {
  bool begun = false;  // the jump at the start is done, and reported
  double time = 0;     // s
  long steps = 0;
  double paced = 0;  // s, when the pace was looked at last
  EventMemory events;
  void history(HistoryVisitor& visit);
};

struct RunPlan {
  double start = 0;                      // s
  double end = 1;                        // s
  double step = 1e-4;                    // s; a fixed method's step, the largest one of a controlled method
  std::function<double(double)> stop{};  // next time after t that a controlled method must hit; none: only the end
  Locate locate = Locate::none;
  RunPoint* point = nullptr;  // where to go on, kept up to date; none: at the start

  // Called before the first step that depends on the end of the run: from there a run with a later end takes other
  // steps.
  std::function<void()> before_end{};
  Validity* validity = nullptr;         // watches each accepted state, and may end the run
  bool stops_when_interrupted = false;  // else an interrupt is thrown, see interrupt.h
};

// Called with the start and after each accepted step; false stops the run, a Divergence thrown ends it as such.
using AfterStep = std::function<bool(double t, const State& y, const JumpReport& jump)>;

// Runs in the default floating-point environment, whatever the caller's is, and leaves the caller's as it was.
// y is the last good state afterwards, also if the run diverged: if a number was no longer finite, a body moved by more
// than its own size in one step, a plate stepped over a body, or the method gave up or would take more than 1e9 steps
// to the end. It ended as invalid if the watch says so; y is then the state in which it was seen. Throws
// std::invalid_argument if the method cannot carry it, Interrupted.
RunEnd run(System& system, Method& method, State& y, const RunPlan& plan, const AfterStep& after_step);

}  // namespace furrow
