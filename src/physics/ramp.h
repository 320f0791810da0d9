// A speed v (m/s) that is reached in a time T from rest, so that a body that stands in contact does not hit at t = 0.
//
//   x(t) = v t^2/(2 T),  x'(t) = v t/T    for t < T
//   x(t) = v (t - T/2),  x'(t) = v        from T on; T = 0: from the start
#pragma once

namespace furrow {

// Place and speed by v.
struct Ramped {
  double time;   // s, x/v: the place is v times this
  double speed;  // -, x'/v
};

inline Ramped ramped(double t, double ramp) {
  if (t < ramp) return {t * t / (2 * ramp), t / ramp};
  return {t - 0.5 * ramp, 1};
}

}  // namespace furrow
