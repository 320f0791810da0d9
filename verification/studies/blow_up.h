// The step at which the solver itself blows up, by bisection: scenes of one oscillator, run by System and run().
#pragma once

#include <string>

#include "scene/scene.h"

namespace furrow::verification {

// A scene with one moving body, at rest but for a small push, whose linear motion is that of a damped oscillator.
struct Oscillation {
  Scene scene;
  double omega = 1;  // rad/s
  double rest = 0;   // m, the coordinate's place of rest
  int axis = 0;      // 0: x, 1: y
};

// A node on a link. Exactly linear.
Oscillation spring_oscillation(double zeta);

// A disc that its weight presses onto a wall, about its place of rest: omega^2 = Sn/m, zeta = sqrt(5/6) beta, by
// contact.h's law, linearised.
Oscillation contact_oscillation(double zeta);

// Whether the push grows at this omega h: the larger of |x - rest| and |v|/omega is greater in the second half of some
// thousand steps than in the quarter before by more than growth_seen a step, or it reaches 1e7 times the push.
bool grows(const std::string& method, const Oscillation& oscillation, double angle);

constexpr double largest_angle = 100;  // of omega h: more is not tried

// -: largest omega h at which it does not grow, at most largest_angle. `guess` shortens the search, no more.
double measured_stable_angle(const std::string& method, const Oscillation& oscillation, double guess);

}  // namespace furrow::verification
