// The motion of a Hertzian impact in time, in the units of damped_hertz.h: before, in and after the contact.
#pragma once

#include <utility>

#include "verification/damped_hertz.h"

namespace furrow::verification {

class HertzPath {
 public:
  // The contact may pull, until it opens, or lets go where its force is zero.
  HertzPath(double beta, bool pull)
      : exact_(beta),
        end_(pull ? exact_.contact_time() : exact_.time(exact_.letting_go())),
        depth_(pull ? 0 : exact_.overlap(exact_.letting_go())),
        exit_(exact_.speed(pull ? exact_.release() : exact_.letting_go())) {}

  long double contact() const { return end_; }

  // Overlap (negative: a gap) and approach speed at the time t after the touch.
  std::pair<long double, long double> at(long double t) const {
    if (t <= 0) return {t, 1};
    if (t >= end_) return {depth_ + exit_ * (t - end_), exit_};
    const long double s = clock(t);
    return {exact_.overlap(s), exact_.speed(s)};
  }

 private:
  // The inverse of exact_.time by bisection, then by Newton's method: dt/ds = p^(-1/5).
  long double clock(long double t) const {
    long double low = 0;
    long double high = exact_.letting_go();
    for (int k = 0; k < 8; ++k) (exact_.time((low + high) / 2) < t ? low : high) = (low + high) / 2;
    // Shortly after the touch p = 5/4 s, so s = 4/5 t^(5/4).
    long double s = low > 0 ? (low + high) / 2 : 0.8L * std::pow(t, 1.25L);
    for (int k = 0; k < 4; ++k) s -= (exact_.time(s) - t) * std::pow(exact_.p(s), 0.2L);
    return s;
  }

  verification::DampedHertz exact_;
  long double end_, depth_, exit_;
};

}  // namespace furrow::verification
