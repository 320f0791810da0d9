// An elastic disc dropped on a floor, in closed form and as seen on a run. Equations: bounce.cpp.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "verification/damped_hertz.h"
#include "verification/drop.h"

namespace furrow::verification::bounce {

struct Elastic {
  double speed, overlap, contact_time, fall_time;
};

inline Elastic closed_form(double young) {
  const long double m = mass_of(of_modulus(young), ball_radius, DiscMass::sphere);
  const long double stiffness = hertz_stiffness(softness(of_modulus(young)), ball_radius);
  const long double v2 = 2 * static_cast<long double>(g) * (drop - ball_radius);
  long double d = std::pow(1.25L * m * v2 / stiffness, 0.4L);
  for (int k = 0; k < 20; ++k) {  // Newton
    d -= (v2 + 2 * g * d - 0.8L * stiffness / m * std::pow(d, 2.5L)) / (2 * g - 2 * stiffness / m * std::pow(d, 1.5L));
  }
  // Near d_max, at a distance r from it, the square root's argument is a difference: taken as one from the energy
  // there.
  const long double half = integral(
      [&](long double x, long double r) {
        const long double lost = 0.8L * stiffness / m * std::pow(d, 2.5L) * -std::expm1(2.5L * std::log1p(-r / d));
        return 1 / std::sqrt(x < r ? v2 + 2 * g * x - 0.8L * stiffness / m * std::pow(x, 2.5L) : lost - 2 * g * r);
      },
      0, d);
  const long double v = std::sqrt(v2);
  return {static_cast<double>(v), static_cast<double>(d), static_cast<double>(2 * half), static_cast<double>(v / g)};
}

struct Event {
  std::string what;
  double time, height;
};

// What happens on a run, each moment worked out from the step around it: parabolas in flight, the turn from a cubic.
inline std::vector<Event> events_of(const Scene& scene, double step, double end) {
  std::vector<Event> events;
  double t0 = 0, y0 = drop, v0 = 0;
  run_scene(scene, "rk4", step, end, [&](double t, const State& y, const JumpReport&) {
    const double y1 = y[1];
    const double v1 = y[3];
    if (y0 >= ball_radius && y1 < ball_radius) {
      const double after = (v0 + std::sqrt(v0 * v0 + 2 * g * (y0 - ball_radius))) / g;
      events.push_back({"touch", t0 + after, ball_radius});
    } else if (y0 < ball_radius && y1 >= ball_radius) {
      events.push_back({"leave", t - (std::sqrt(v1 * v1 + 2 * g * (y1 - ball_radius)) - v1) / g, ball_radius});
    }
    if (v0 < 0 && v1 >= 0) {
      const double share = v0 / (v0 - v1);
      events.push_back({"turn", t0 + share * (t - t0), y0 + 0.5 * v0 * share * (t - t0)});
    } else if (v0 > 0 && v1 <= 0) {
      events.push_back({"peak", t0 + v0 / g, y0 + v0 * v0 / (2 * g)});
    }
    t0 = t;
    y0 = y1;
    v0 = v1;
    return true;
  });
  return events;
}

}  // namespace furrow::verification::bounce
