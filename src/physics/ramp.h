// A motion that reaches its speed v in the time T, at a constant acceleration.
//
//   speed  v t/T,        v            from T on
//   way    v t^2/(2 T),  v (t - T/2)  from T on
#pragma once

namespace furrow {

// -: of the speed. t, ramp: s; ramp = 0: at once.
inline double ramped_share(double t, double ramp) { return t < ramp ? t / ramp : 1; }

// s: the time in which the full speed goes as far.
inline double ramped_time(double t, double ramp) { return t < ramp ? t * t / (2 * ramp) : t - 0.5 * ramp; }

}  // namespace furrow
