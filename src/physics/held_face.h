// The face of a plate that a body keeps: a body that met one face is pushed out through that face, however deep it is
// pressed, and never comes out of the opposite one.
//
// What it feels. A body on face f feels the rectangle as if there were no opposite face: it goes on for ever behind f.
// With the depths a behind f, and b and c behind the two neighbours of f, the signed distance D and its direction are
//
//   outside   D = distance to the nearest point, corners included,   n = towards it
//   inside    D = -min*(a, min*(b, c)),                              n = -grad D
//
//   min*(p, q) = p                                   if 2 p <= q
//              = q (s - 4/7 (s - 1/2)^2),  s = p/q   if p <= q < 2 p;   for p > q the same with p and q exchanged
//
// min* and its first derivatives are continuous, so the force -Fn n is continuous: where a body slips round a corner, it
// turns from one face to the other. Since n = -grad D everywhere, Fe n has a potential, and a closed way round a corner
// returns its energy. For that n is shorter than 1 where min* is rounded: down to 3/7 sqrt(2) where two faces meet. Ft t
// is shortened alike; the spin's part of the slip is not. The corner point itself has no direction: there n is that of f.
//
// Limit: a contact can overlap and yet push nowhere. n = 0 midway between the two neighbours of f, b = c, where their depth
// is at most 7/12 of the depth a behind f.
//
// The life of a held face, at each jump (system/held_faces.h):
//
//   birth      The body is closer than Parts::margin: it takes the nearest face, the one of least depth. Depths are signed:
//              negative in front of a face.
//   hand-over  It takes the nearest face as soon as that face gives the same D and the same n, to the last bit: beside
//              an edge both do, so it can go round a corner and no force jumps. Right through the plate none do.
//   end        It is further away than the margin, where there is no force.
//
// A body without a held face feels the nearest one: birth changes no force either. All of this only where a scene has
// `tight_plates`: else no face is kept, and a body feels nearest_on_rectangle() of geometry.h.
//
// Limit: a body without a held face that moves, in one step, from beyond the margin to behind the middle of the plate gets
// the face that is nearest by then, the opposite one, and comes out there. For that its centre moves, against the plate, by
// R + margin + half the thickness or more.
//
// Rejected: turning at the diagonal of a corner, D = -min(a, b), which has the same potential elsewhere, but a force that
// turns by 90 degrees at once.
#pragma once

#include "physics/constants.h"
#include "physics/geometry.h"

namespace furrow {

enum Face : int { no_face = -1, left_face, right_face, lower_face, upper_face };

// m, how far a point is behind the line of a face; negative in front of it.
inline double depth_behind(Vec2 p, const Rectangle& r, Face face) {
  switch (face) {
    case left_face:
      return p.x - r.left;
    case right_face:
      return r.right - p.x;
    case lower_face:
      return p.y - r.lower;
    default:
      return r.upper - p.y;
  }
}

// Of equally near ones the first of left, right, lower, upper.
inline Face nearest_face(Vec2 p, const Rectangle& r) {
  Face nearest = left_face;
  for (const Face face : {right_face, lower_face, upper_face}) {
    if (depth_behind(p, r, face) < depth_behind(p, r, nearest)) nearest = face;
  }
  return nearest;
}

inline Rectangle without_opposite(Rectangle r, Face face) {
  (face == left_face    ? r.right
   : face == right_face ? r.left
   : face == lower_face ? r.upper
                        : r.lower) = face == left_face || face == lower_face ? infinity : -infinity;
  return r;
}

// min* (m) and its derivatives by p and q (-).
struct RoundedLeast {
  double value, of_p, of_q;
};

inline RoundedLeast rounded_least(double p, double q) {
  if (q < p) {
    const RoundedLeast exchanged = rounded_least(q, p);
    return {exchanged.value, exchanged.of_q, exchanged.of_p};
  }
  if (p + p <= q) return {p, 1, 0};
  const double s = p / q;
  const double share = s - 4.0 / 7.0 * (s - 0.5) * (s - 0.5);
  const double slope = 1 - 8.0 / 7.0 * (s - 0.5);
  return {q * share, slope, share - s * slope};
}

// p: inside `r`, which is open opposite to `face`.
inline Nearest way_out(Vec2 p, const Rectangle& r, Face face) {
  const bool upright = face == left_face || face == right_face;
  const Face first = upright ? lower_face : left_face, second = upright ? upper_face : right_face;
  const RoundedLeast beside = rounded_least(depth_behind(p, r, first), depth_behind(p, r, second));
  const RoundedLeast all = rounded_least(depth_behind(p, r, face), beside.value);
  const double ahead = face == left_face || face == lower_face ? all.of_p : -all.of_p;
  const double aside = all.of_q * (beside.of_p - beside.of_q);
  return {-all.value, upright ? ahead : aside, upright ? aside : ahead};
}

inline Nearest nearest_on_held_face(Vec2 p, const Rectangle& rectangle, Face face) {
  const Rectangle r = without_opposite(rectangle, face);
  const Vec2 nearest{std::min(std::max(p.x, r.left), r.right), std::min(std::max(p.y, r.lower), r.upper)};
  if (nearest == p) return way_out(p, r, face);
  const Vec2 d = nearest - p;
  const double distance = std::sqrt(dot(d, d));
  return {distance, d.x / distance, d.y / distance};
}

// The face after a jump that finds the body here, if it is closer than the margin.
inline Face face_after(Vec2 p, const Rectangle& r, Face held) {
  const Face nearest = nearest_face(p, r);
  if (held == no_face) return nearest;
  const Nearest old = nearest_on_held_face(p, r, held), other = nearest_on_held_face(p, r, nearest);
  const bool same = old.distance == other.distance && old.nx == other.nx && old.ny == other.ny;
  return same ? nearest : held;
}

}  // namespace furrow
