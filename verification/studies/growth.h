// Whether a motion grows, from its size step by step: by more than `rate` a step between the third and the last quarter
// of its steps. Not earlier: a root of a many-step method that the start excites but little, by the error of its first
// values, shows only once the motion itself has decayed; and near a double root what decays first rises by thousands.
#pragma once

#include <algorithm>
#include <cmath>

namespace furrow::verification {

class Growth {
 public:
  Growth(int steps, double rate) : steps_(steps), rate_(rate) {}

  // False once no more is needed.
  bool add(double size) {
    if (n_ == 0) start_ = size;
    if (4 * n_ >= 3 * steps_) {
      last_ = std::max(last_, size);
    } else if (2 * n_ >= steps_) {
      third_ = std::max(third_, size);
    }
    over_ = !(size < 1e4 * start_);
    return !over_ && ++n_ < steps_;
  }

  bool seen() const {
    const bool above_round_off = last_ > 1e-2 * start_;  // which swings by itself
    const bool grew = last_ > third_ * std::exp(rate_ * steps_ / 4);
    const bool full_grown = third_ > 1e2 * start_ && last_ > third_ / 2;  // as far as clipping and friction let it
    return over_ || (above_round_off && (grew || full_grown));
  }

 private:
  int steps_;
  double rate_;
  int n_ = 0;
  double start_ = 0, third_ = 0, last_ = 0;
  bool over_ = false;
};

}  // namespace furrow::verification
