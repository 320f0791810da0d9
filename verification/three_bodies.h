// A disc, a node, a spring and another node in a line, from the touch on, without the solver.
#pragma once

#include <cmath>

#include "verification/coupling_scenes.h"

namespace furrow::verification::coupling {

struct Line {
  long double disc, upper, lower;  // m/s
};

// Disc, node, spring, node from the touch to `end`, elastic: Runge-Kutta over t = end s^4, which takes the root off the
// onset.
inline Line three_bodies(long double spring, long double end, int steps) {
  struct Motion {
    long double q[3], v[3];
  };
  const long double mass[3] = {disc_mass, node_mass, node_mass};
  const auto rates = [&](const Motion& y, long double scale) {
    Motion r{};
    const long double d = std::fmax(0.0L, y.q[1] - y.q[0]);  // heights from where each is at the touch
    const long double contact = hertz * d * std::sqrt(d);
    const long double pull = spring * (y.q[1] - y.q[2]);
    const long double force[3] = {contact, -contact - pull, pull};
    for (int i = 0; i < 3; ++i) {
      r.q[i] = y.v[i] * scale;
      r.v[i] = force[i] / mass[i] * scale;
    }
    return r;
  };
  const auto moved = [](const Motion& y, const Motion& k, long double h) {
    Motion z = y;
    for (int i = 0; i < 3; ++i) {
      z.q[i] += h * k.q[i];
      z.v[i] += h * k.v[i];
    }
    return z;
  };
  Motion y{{0, 0, 0}, {-closing, 0, 0}};
  const long double h = 1.0L / steps;
  for (int n = 0; n < steps; ++n) {
    const auto scale = [&](long double s) { return end * 4 * s * s * s; };
    const Motion k1 = rates(y, scale(n * h));
    const Motion k2 = rates(moved(y, k1, h / 2), scale((n + 0.5L) * h));
    const Motion k3 = rates(moved(y, k2, h / 2), scale((n + 0.5L) * h));
    const Motion k4 = rates(moved(y, k3, h), scale((n + 1) * h));
    y = moved(moved(moved(moved(y, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  }
  return {y.v[0], y.v[1], y.v[2]};
}

}  // namespace furrow::verification::coupling
