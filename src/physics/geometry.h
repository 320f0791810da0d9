// Nearest points and signed distances. (nx, ny) points from the disc or node to the other part, inside a rectangle away
// from the nearest way out. Its length is 1; shorter only inside the rounded corners of a kept face (held_face.h).
#pragma once

#include <algorithm>
#include <cmath>

#include "physics/vec2.h"

namespace furrow {

struct Nearest {
  double distance;  // m, to the surface of the other part; negative inside it
  double nx, ny;    // -, direction
};

struct Rectangle {
  double left, right, lower, upper;  // m
};

// The line through `point`; the side that its unit normal points to is free.
inline Nearest nearest_on_wall(Vec2 p, Vec2 point, Vec2 normal) {
  return {dot(p - point, normal), -normal.x, -normal.y};
}

// From inside the way out is through the nearest face; of two equally near ones the first of left, right, lower, upper.
inline Nearest nearest_on_rectangle(Vec2 p, const Rectangle& r) {
  const Vec2 nearest{std::min(std::max(p.x, r.left), r.right), std::min(std::max(p.y, r.lower), r.upper)};
  if (nearest != p) {
    const Vec2 d = nearest - p;
    const double distance = std::sqrt(dot(d, d));
    return {distance, d.x / distance, d.y / distance};
  }
  Nearest out{-(p.x - r.left), 1, 0};
  if (-(r.right - p.x) > out.distance) out = {-(r.right - p.x), -1, 0};
  if (-(p.y - r.lower) > out.distance) out = {-(p.y - r.lower), 0, 1};
  if (-(r.upper - p.y) > out.distance) out = {-(r.upper - p.y), 0, -1};
  return out;
}

struct NearestOnSegment {
  double distance2;  // m^2
  double dx, dy;     // m, from the point to the nearest one
  double share;      // -, 0 at a, 1 at b
};

// -: where on the way from a to b, 0 to 1, the segment is nearest to p.
inline double nearest_share(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 u = b - a;
  const double length2 = dot(u, u);
  const double along = dot(p - a, u);
  return length2 > 0 ? std::min(std::max(along / length2, 0.0), 1.0) : 0.0;
}

// The point of the segment at this share, as seen from p.
inline NearestOnSegment point_of_segment(Vec2 p, Vec2 a, Vec2 b, double share) {
  const Vec2 u = b - a;
  const double dx = a.x + share * u.x - p.x;
  const double dy = a.y + share * u.y - p.y;
  return {dx * dx + dy * dy, dx, dy, share};
}

// The nearest to p among the end nodes a, b and `auxiliary` equally spaced points between them; auxiliary = 0: the
// exact nearest point of the segment.
inline NearestOnSegment nearest_on_segment(Vec2 p, Vec2 a, Vec2 b, int auxiliary) {
  double share = nearest_share(p, a, b);
  if (auxiliary > 0)  // equally spaced: the nearest one is the nearest to the foot of the perpendicular
    share = std::floor(share * (auxiliary + 1) + 0.5) / (auxiliary + 1);
  return point_of_segment(p, a, b, share);
}

// Of a torn segment only its ends are left.
inline NearestOnSegment nearest_end(Vec2 p, Vec2 a, Vec2 b) {
  return point_of_segment(p, a, b, nearest_share(p, a, b) < 0.5 ? 0 : 1);
}

}  // namespace furrow
