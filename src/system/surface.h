// How far a disc or node is from the part that it may touch.
#pragma once

#include "physics/geometry.h"
#include "physics/ramp.h"
#include "system/contact.h"
#include "system/parts.h"

namespace furrow {

struct Gap {
  double gap;     // m, between the surfaces; negative: the overlap
  double nx, ny;  // direction from the disc or node to the other part, see system/contact.h
};

struct PlateAt {
  double left, lower, vx, vy;  // m, m/s
};

// While a scene is prepared its plates stand still.
inline PlateAt plate_at(const PlatePart& p, double t, bool preparing) {
  if (preparing) return {p.left, p.lower, 0, 0};
  const Ramped at = ramped(t, p.ramp);
  return {p.left + p.vx * at.time, p.lower + p.vy * at.time, p.vx * at.speed, p.vy * at.speed};
}

inline Rectangle rectangle_at(const PlatePart& p, double t) {
  const PlateAt at = plate_at(p, t, false);
  return {at.left, at.left + p.width, at.lower, at.lower + p.height};
}

// A disc or node at `a` against the wall or plate of the pair. t: s, 0 while a scene is prepared.
inline Gap flat_gap(const Parts& parts, const ContactId& pair, Vec2 a, double t) {
  Nearest n{};
  if (of_wall(pair.kind)) {
    const WallPart& w = parts.wall[pair.b];
    n = nearest_on_wall(a, {w.px, w.py}, {w.nx, w.ny});
  } else {
    n = nearest_on_rectangle(a, rectangle_at(parts.plate[pair.b], t));
  }
  return {n.distance - (of_disc(pair.kind) ? parts.disc.radius[pair.a] : 0), n.nx, n.ny};
}

// A disc against the nearest point of a border.
inline Gap border_gap(const NearestOnSegment& n, double radius) {
  const double distance = std::sqrt(n.distance2);
  return {distance - radius, n.dx / distance, n.dy / distance};
}

}  // namespace furrow
