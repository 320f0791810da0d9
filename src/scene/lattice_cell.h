// The shape of a lattice's cell: its links only know lengths, so they do not feel that it has turned over.
#pragma once

#include "scene/border.h"

namespace furrow {

struct LatticeCell {
  Vec2 a, b, c, d;  // m, its corners, which go round to the left where it stands as it was made
};

// m^2, twice the area of the triangle a, b, c: positive if they go round to the left.
inline double turn(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// What is wrong with a cell: one that is inside out goes round to the right; of one that is folded over two sides cross.
// Empty if nothing is.
inline const char* turned_over(const LatticeCell& q) {
  const bool convex =
      turn(q.a, q.b, q.c) >= 0 && turn(q.b, q.c, q.d) >= 0 && turn(q.c, q.d, q.a) >= 0 && turn(q.d, q.a, q.b) >= 0;
  if (convex) return "";
  if (turn(q.a, q.b, q.c) + turn(q.a, q.c, q.d) < 0) return "is inside out";
  return segments_cross(q.a, q.b, q.c, q.d) || segments_cross(q.b, q.c, q.d, q.a) ? "is folded over" : "";
}

}  // namespace furrow
