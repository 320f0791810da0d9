// Nearest points and signed distances. Unit vectors n point from the disc or node to the other part, from inside of a
// rectangle against the nearest way out.
#pragma once

#include <algorithm>
#include <cmath>

namespace furrow {

struct Nearest {
  double distance;  // m, to the surface of the other part; negative inside it
  double nx, ny;
};

// The side of the line that the unit normal (wx, wy) points to is free.
inline Nearest nearest_on_wall(double x, double y, double px, double py, double wx, double wy) {
  return {(x - px) * wx + (y - py) * wy, -wx, -wy};
}

// Rectangle [left, right] x [lower, upper]. From inside the way out is through the nearest face; of two equally near
// ones the first of left, right, lower, upper.
inline Nearest nearest_on_rectangle(double x, double y, double left, double right, double lower, double upper) {
  const double cx = std::min(std::max(x, left), right);
  const double cy = std::min(std::max(y, lower), upper);
  if (cx != x || cy != y) {
    const double dx = cx - x;
    const double dy = cy - y;
    const double distance = std::sqrt(dx * dx + dy * dy);
    return {distance, dx / distance, dy / distance};
  }
  Nearest out{-(x - left), 1, 0};
  if (-(right - x) > out.distance) out = {-(right - x), -1, 0};
  if (-(y - lower) > out.distance) out = {-(y - lower), 0, 1};
  if (-(upper - y) > out.distance) out = {-(upper - y), 0, -1};
  return out;
}

struct NearestOnSegment {
  double distance2;  // m^2
  double dx, dy;     // m, from the point to the nearest one
  double share;      // 0 at a, 1 at b
};

// Of the end nodes and `auxiliary` equally spaced points between them the nearest to (x, y); auxiliary = 0: the exact
// nearest point of the segment. A torn segment has only its ends left.
inline NearestOnSegment nearest_on_segment(double x, double y, double ax, double ay, double bx, double by,
                                           int auxiliary, bool torn) {
  const double ux = bx - ax;
  const double uy = by - ay;
  const double length2 = ux * ux + uy * uy;
  const double along = (x - ax) * ux + (y - ay) * uy;
  double share = length2 > 0 ? std::min(std::max(along / length2, 0.0), 1.0) : 0.0;
  if (torn) {
    share = share < 0.5 ? 0 : 1;
  } else if (auxiliary > 0) {  // equally spaced: the nearest one is the nearest to the foot of the perpendicular
    share = std::floor(share * (auxiliary + 1) + 0.5) / (auxiliary + 1);
  }
  const double dx = ax + share * ux - x;
  const double dy = ay + share * uy - y;
  return {dx * dx + dy * dy, dx, dy, share};
}

}  // namespace furrow
