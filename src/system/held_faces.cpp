#include "system/held_faces.h"

#include <algorithm>

#include "system/order.h"

namespace furrow {
namespace {

Rectangle grown(const Rectangle& r, const Rectangle& by) {
  return {r.left - by.left, r.right + by.right, r.lower - by.lower, r.upper + by.upper};
}

Nearest nearest_on_plate(const Parts& parts, const HeldFaces& held, const ContactId& pair, Vec2 at, double t) {
  const PlatePart& plate = parts.plate[pair.b];
  const Rectangle r = whole_at(plate, t);
  const Face face = face_of(held, pair);
  return nearest_on_held_face(at, r, face == no_face ? nearest_face(at, r) : face);
}

bool holds(const PlatePart& plate, double t, Vec2 p) {
  const double near = plate.flush_within;
  const Rectangle r = grown(rectangle_at(plate, t), {near, near, near, near});
  return p.x >= r.left && p.x <= r.right && p.y >= r.lower && p.y <= r.upper;
}

bool before(const HeldFace& one, const HeldFace& other) { return comes_before(one, other); }

}  // namespace

Rectangle whole_at(const PlatePart& plate, double t) { return grown(rectangle_at(plate, t), plate.goes_on); }

Face face_of(const HeldFaces& held, const ContactId& c) {
  const HeldFace sought{c.kind, c.a, c.b, no_face};
  const auto found = std::lower_bound(held.begin(), held.end(), sought, before);
  return found == held.end() || before(sought, *found) ? no_face : found->face;
}

Face face_after(const Parts& parts, const HeldFaces& held, const ContactId& pair, Vec2 at, double t) {
  const double radius = of_disc(pair.kind) ? parts.disc.radius[pair.a] : 0;
  const Rectangle r = whole_at(parts.plate[pair.b], t);
  const Face own = face_of(held, pair), nearest = nearest_face(at, r);
  const double distance = nearest_on_held_face(at, r, own == no_face ? nearest : own).distance;
  if (!(distance - radius < parts.margin)) return no_face;
  return own == nearest ? own : furrow::face_after(at, r, own);
}

int felt_instead(const Parts& parts, const HeldFaces& held, const ContactId& pair, Vec2 at, double t) {
  const PlatePart& own = parts.plate[pair.b];
  if (own.flush.empty()) return -1;
  const Nearest here = nearest_on_plate(parts, held, pair, at, t);
  const Vec2 q{at.x + here.distance * here.nx, at.y + here.distance * here.ny};
  for (const int other : own.flush) {
    if (!holds(parts.plate[other], t, q)) continue;
    const Nearest there = nearest_on_plate(parts, held, {pair.kind, pair.a, other}, at, t);
    if (!(here.nx * there.nx + here.ny * there.ny > 0)) continue;
    const bool nearer = there.distance < here.distance || (there.distance == here.distance && other < pair.b);
    if (nearer || !holds(own, t, q)) return other;
  }
  return -1;
}

Gap held_gap(const Parts& parts, const HeldFaces& held, const ContactId& pair, Vec2 at, double t) {
  if (!of_plate(pair.kind) || !parts.tight_plates) return flat_gap(parts, pair, at, t);
  const Nearest n = nearest_on_plate(parts, held, pair, at, t);
  const double gap = n.distance - (of_disc(pair.kind) ? parts.disc.radius[pair.a] : 0);
  const bool elsewhere = gap < 0 && felt_instead(parts, held, pair, at, t) >= 0;
  return {elsewhere ? 0 : gap, n.nx, n.ny};
}

namespace {

constexpr double flush_of_side = 1e-9;

double least_side(const PlatePart& p) { return std::min(p.width, p.height); }

bool within(double one, double other, double near) { return std::abs(one - other) <= near; }

bool covers(double from, double to, double other_from, double other_to, double near) {
  return other_from <= from + near && other_to >= to - near;
}

// How far `p` goes on into `q`, by each of its faces.
Rectangle into(const Rectangle& p, const Rectangle& q, double near) {
  Rectangle on{0, 0, 0, 0};
  if (covers(p.lower, p.upper, q.lower, q.upper, near)) {
    if (within(p.left, q.right, near)) on.left = p.left - q.left;
    if (within(p.right, q.left, near)) on.right = q.right - p.right;
  }
  if (covers(p.left, p.right, q.left, q.right, near)) {
    if (within(p.lower, q.upper, near)) on.lower = p.lower - q.lower;
    if (within(p.upper, q.lower, near)) on.upper = q.upper - p.upper;
  }
  return on;
}

bool touch(const Rectangle& p, const Rectangle& q, double near) {
  return p.left <= q.right + near && q.left <= p.right + near && p.lower <= q.upper + near && q.lower <= p.upper + near;
}

void widen(Rectangle& r, const Rectangle& by) {
  r.left = std::max(r.left, by.left), r.right = std::max(r.right, by.right);
  r.lower = std::max(r.lower, by.lower), r.upper = std::max(r.upper, by.upper);
}

// Into a wall along the axes whose surface the plate keeps its place at.
void stand_on(const WallPart& w, PlatePart& p) {
  const Rectangle r = rectangle_at(p, 0);
  const double near = flush_of_side * least_side(p);
  if (p.vx * w.nx + p.vy * w.ny != 0) return;
  if (w.nx == 0) {
    if (w.ny > 0 && r.lower <= w.py + near) p.goes_on.lower = infinity;
    if (w.ny < 0 && r.upper >= w.py - near) p.goes_on.upper = infinity;
  } else if (w.ny == 0) {
    if (w.nx > 0 && r.left <= w.px + near) p.goes_on.left = infinity;
    if (w.nx < 0 && r.right >= w.px - near) p.goes_on.right = infinity;
  }
}

}  // namespace

void join_plates(Parts& parts) {
  const int count = static_cast<int>(parts.plate.size());
  for (int a = 0; a < count; ++a) {
    PlatePart& p = parts.plate[a];
    p.flush_within = flush_of_side * least_side(p);
    for (int b = 0; b < count; ++b) {
      const PlatePart& q = parts.plate[b];
      const double near = flush_of_side * std::min(least_side(p), least_side(q));
      const Rectangle own = rectangle_at(p, 0), other = rectangle_at(q, 0);
      if (a == b || p.vx != q.vx || p.vy != q.vy || p.ramp != q.ramp || !touch(own, other, near)) continue;
      p.flush.push_back(b);
      parts.flush_plates = true;
      widen(p.goes_on, into(own, other, near));
    }
    for (const WallPart& w : parts.wall) stand_on(w, p);
  }
}

}  // namespace furrow
