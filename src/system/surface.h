// How far a disc or node is from the part that it may touch.
#pragma once

#include "physics/geometry.h"
#include "system/contact.h"
#include "system/parts.h"

namespace furrow {

// Where everything is. Arrays of discs and of nodes (fixed ones too); m, s.
struct Placement {
  double t;
  const double* disc_x;
  const double* disc_y;
  const double* node_x;
  const double* node_y;
};

struct Gap {
  double gap;     // m, between the surfaces; negative: the overlap
  double nx, ny;  // unit vector from the disc or node to the other part
};

struct Rectangle {
  double left, right, lower, upper;  // m
};

struct PlateAt {
  double left, lower, vx, vy;  // m, m/s
};

// While a scene is prepared its plates stand still.
inline PlateAt plate_at(const PlatePart& p, double t, bool preparing) {
  if (preparing) return {p.left, p.lower, 0, 0};
  return {p.left + p.vx * t, p.lower + p.vy * t, p.vx, p.vy};
}

inline Rectangle rectangle_at(const PlatePart& p, double t) {
  const double left = p.left + p.vx * t;
  const double lower = p.lower + p.vy * t;
  return {left, left + p.width, lower, lower + p.height};
}

// Disc or node `a` against wall or plate `b`.
inline Gap flat_gap(const Parts& parts, const Placement& now, ContactKind kind, int a, int b) {
  const double x = of_disc(kind) ? now.disc_x[a] : now.node_x[a];
  const double y = of_disc(kind) ? now.disc_y[a] : now.node_y[a];
  Nearest n{};
  if (of_wall(kind)) {
    const WallPart& w = parts.wall[b];
    n = nearest_on_wall(x, y, w.px, w.py, w.nx, w.ny);
  } else {
    const Rectangle p = rectangle_at(parts.plate[b], now.t);
    n = nearest_on_rectangle(x, y, p.left, p.right, p.lower, p.upper);
  }
  return {n.distance - (of_disc(kind) ? parts.disc.radius[a] : 0), n.nx, n.ny};
}

// Disc `a` against the border segment `s`; auxiliary and torn as in nearest_on_segment.
inline NearestOnSegment segment_distance(const Parts& parts, const Placement& now, int a, int s, int auxiliary,
                                         bool torn) {
  const int i = parts.border.a[s];
  const int j = parts.border.b[s];
  return nearest_on_segment(now.disc_x[a], now.disc_y[a], now.node_x[i], now.node_y[i], now.node_x[j], now.node_y[j],
                            auxiliary, torn);
}

}  // namespace furrow
