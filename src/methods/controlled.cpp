#include "methods/controlled.h"

#include <algorithm>
#include <cmath>

#include "physics/constants.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr int most_tries = 60;  // a rejected step shrinks to a tenth at most and to 0.8 at least
constexpr double target = 0.5;
constexpr double least_error = 1e-6;  // below it a step could grow without end

double power_1_8(double x) { return std::sqrt(std::sqrt(std::sqrt(x))); }
double power_3_8(double x) { return power_1_8(x) * std::sqrt(std::sqrt(x)); }

}  // namespace

double ControlledMethod::scaled_error(const OdeSystem& system, const State& y, double h) const {
  double all = 0;
  for (const double v : next_) all += v - v;  // NaN if any number is not finite, the ledger's included
  if (all != 0) return infinity;
  double greatest = 0;
  for (std::size_t i = 0; i < system.controlled(); ++i) {
    const double scale = tolerances_.absolute + tolerances_.relative * (std::fabs(y[i]) + h * std::fabs(now_[i]));
    const double error = std::fabs(error_[i]) / scale;
    if (!(error < infinity)) return infinity;  // nor a number
    greatest = std::max(greatest, error);
  }
  return greatest;
}

// The next step after an accepted one. `cut`: it ended at a stop, which says nothing against the longer one proposed.
void ControlledMethod::choose(double h, double error, bool cut) {
  const double e = std::max(error, least_error);
  if (steps_ == 0) {
    h_before_ = h;
    e_before_ = e;
  }
  const double filtered = power_1_8(target / e) * power_1_8(target / e_before_) / power_3_8(h / h_before_);
  const double chosen = h * std::min(std::max(filtered, 0.2), 2.0);
  proposal_ = cut ? std::max(proposal_, chosen) : chosen;
  h_before_ = h;
  e_before_ = e;
}

double ControlledMethod::step(const OdeSystem& system, double t, State& y, double h) {
  for (State* room : {&now_, &next_, &error_}) room->resize(y.size());
  prepare(system, t, y);
  double trial = std::min(proposal_, h);
  bool cut = proposal_ > h;
  for (int tries = 0; tries < most_tries; ++tries) {
    double error = infinity;
    try {
      attempt(system, t, y, trial);
      error = scaled_error(system, y, trial);
    } catch (const Divergence&) {  // the attempt failed; a shorter one may succeed
    }
    if (error <= 1) {
      choose(trial, error, cut);
      y.swap(next_);
      ++steps_;
      accept(trial);
      return trial;
    }
    ++rejections_;
    cut = false;
    steps_ = 0;  // the filter starts again
    trial *= error < infinity ? std::max(power_3_8(target / error), 0.1) : 0.1;
    proposal_ = trial;
  }
  throw Divergence("no step of " + info_.name + " met its tolerance in " + std::to_string(most_tries) +
                   " tries; the last was " + shortest(trial) + " s long");
}

}  // namespace furrow
