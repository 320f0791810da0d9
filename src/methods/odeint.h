// What the adapters of Boost.Odeint share. The steppers' headers are slow to compile: they stay in odeint_*.cpp.
//
// Traps of Boost 1.74, each handled and named where it occurs: buffers that never grow, multistep histories that
// outlive a jump or another step, in-place starters, `order()` one too high, error norms that take a NaN for a good
// step, retries without end, forces evaluated with old velocities, a time that symplectic steppers do not pass on, and
// a std::exit(0). The integrate_* functions, which drop last steps, are not used: run() steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "methods/method.h"
#include "scene/wording.h"

namespace furrow {

template <class Adapter>
MethodEntry odeint_entry(MethodInfo info) {
  info.family = "odeint";
  return {info, [info](const Tolerances& tolerances) -> std::unique_ptr<Method> {
            return std::make_unique<Adapter>(info, tolerances);
          }};
}

// Step control around one try of a stepper. Tries are bounded: on a NaN a loop around `try_step` would never end.
class ControlledOdeint : public Method {
 public:
  ControlledOdeint(MethodInfo info, const Tolerances& tolerances)
      : Method(std::move(info)), first_step_(tolerances.first_step), proposal_(tolerances.first_step) {}

  // What fitted the other force is no proposal for this one.
  void restart() override { proposal_ = first_step_; }

  double step(const OdeSystem& system, double t, State& y, double h) final {
    begin(system, t, y);
    const bool cut = proposal_ > h;
    double trial = std::min(proposal_, h);
    for (int tries = 0; tries < most_tries; ++tries) {
      const double tried = trial;
      bool good = false;
      try {
        good = attempt(system, t, y, trial) && finite(next_);
      } catch (const Divergence&) {  // the trial left what can be computed; a shorter one may not
      }
      if (good) {
        proposal_ = cut && tries == 0 ? std::max(proposal_, trial) : trial;
        y.swap(next_);
        accept();
        return tried;
      }
      ++rejections_;
      if (!(trial < tried)) trial = 0.2 * tried;  // the stepper had no complaint
    }
    throw Divergence("no step of " + info_.name + " met its tolerance in " + std::to_string(most_tries) +
                     " tries; the last was " + shortest(trial) + " s long");
  }

 protected:
  // Before the first try of a step.
  virtual void begin(const OdeSystem& system, double t, const State& y) = 0;
  // Tries a step over `trial` into next_ and sets `trial` to what it would try next. True if the tolerance was met.
  virtual bool attempt(const OdeSystem& system, double t, const State& y, double& trial) = 0;
  // next_ has become the state.
  virtual void accept() {}

  void remember(HistoryVisitor& visit) override { visit("proposal", proposal_); }

  State next_;

 private:
  static constexpr int most_tries = 60;  // a step is divided by up to 5 at a try: enough to reach round-off

  static bool finite(const State& y) {
    return std::all_of(y.begin(), y.end(), [](double v) { return std::isfinite(v); });
  }

  double first_step_;  // s
  double proposal_;    // s
};

}  // namespace furrow
