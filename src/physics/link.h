// Spring and damper in parallel between two nodes of a lattice; forces on node i.
//
//   r   = r_i - r_j,  v = v_i - v_j,  e = r/|r|
//   F_k = -k (|r| - l) e
//   F_c = -c (v . e) e   axial
//   F_c = -c v           full
//
// The paper's Eq. (1) has the opposite sign as printed, under which a stretched spring pushes its ends away from each
// other; its Eq. (2) as printed is the `full` form, which brakes a rigid rotation, while its text says the axial one.
#pragma once

#include <cmath>

namespace furrow {

struct LinkForce {
  double spring;   // N, tension positive
  double fx, fy;   // N, on node i, spring and damper together
  double damping;  // W, taken by the damper
};

// (rx, ry) m and (vx, vy) m/s of node i against node j; rest length m, stiffness N/m, damping N s/m.
inline LinkForce link_force(double rx, double ry, double vx, double vy, double rest, double stiffness, double damping,
                            bool axial) {
  LinkForce f{};
  const double length = std::sqrt(rx * rx + ry * ry);
  const double ex = rx / length;
  const double ey = ry / length;
  f.spring = stiffness * (length - rest);
  const double stretching = vx * ex + vy * ey;
  const double dx = axial ? stretching * ex : vx;
  const double dy = axial ? stretching * ey : vy;
  f.fx = -f.spring * ex - damping * dx;
  f.fy = -f.spring * ey - damping * dy;
  f.damping = damping * (dx * vx + dy * vy);
  return f;
}

}  // namespace furrow
