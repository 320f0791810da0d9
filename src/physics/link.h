// Spring and damper in parallel between two nodes of a lattice; forces on node i.
//
//   r   = r_i - r_j,  v = v_i - v_j,  e = r/|r|
//   F_k = -k (|r| - l) e
//   F_c = -c (v . e) e   axial
//   F_c = -c v           full
//
// with stiffness k (N/m), rest length l (m) and damping c (N s/m); |r| > 0, for ends in one place have no direction.
// The paper's (README.md) Eq. (1) has the opposite sign as printed, under which a stretched spring pushes its ends away
// from each other; its Eq. (2) as printed is the `full` form, which brakes a rigid rotation, while its text says the
// axial one.
#pragma once

#include <cmath>

#include "physics/vec2.h"

namespace furrow {

enum class Damper { axial, full };           // along the link, or on the whole relative velocity
enum class TearRule { tension, magnitude };  // which spring force is compared with the strength

struct LinkForce {
  double spring;   // N, force of the spring, tension positive
  double fx, fy;   // N, on node i, spring and damper together
  double damping;  // W, power that the damper dissipates
};

// r (m) and v (m/s) of node i against node j; rest length m, stiffness N/m, damping N s/m.
[[gnu::always_inline]] inline LinkForce link_force(Vec2 r, Vec2 v, double rest, double stiffness, double damping,
                                                   Damper damper) {
  LinkForce f{};
  const double length = std::sqrt(dot(r, r));
  const Vec2 e{r.x / length, r.y / length};
  f.spring = stiffness * (length - rest);
  const double stretching = dot(v, e);
  const Vec2 damped = damper == Damper::axial ? Vec2{stretching * e.x, stretching * e.y} : v;
  f.fx = -f.spring * e.x - damping * damped.x;
  f.fy = -f.spring * e.y - damping * damped.y;
  f.damping = damping * dot(damped, v);
  return f;
}

// Whether a link of this strength (N) tears under the force of its spring (N). The force of its damper does not count.
[[gnu::always_inline]] inline bool link_tears(double spring, double strength, TearRule rule) {
  return (rule == TearRule::magnitude ? std::fabs(spring) : spring) > strength;
}

}  // namespace furrow
