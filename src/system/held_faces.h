// Which face of which plate each body keeps: discrete state (see physics/held_face.h), where a scene has
// `tight_plates`. And how plates that stand on walls or lie flush with others are one surface.
//
//   on a wall    A face of a plate that lies on or behind a wall along the axes, and stays there, is no face: the plate
//                goes on behind the wall for ever.
//   flush        A face that lies wholly on a face of another plate of the same velocity is none either: the plate goes
//                on to that plate's far side.
//   one surface  Of two flush plates P and Q, P does not feel a body whose nearest point q of P lies in Q, if n of P and
//                Q have a common direction and either q is outside P itself, or Q is nearer, or both are as near and Q
//                comes first. So a body over a joint has one contact.
//   one spring   The tangential spring of such a P is that of Q, and grows with it: when the body comes to P, it is there.
//
// Lengths below 1e-9 of the smallest side of the two are none: what lies as close as that is flush.
#pragma once

#include <vector>

#include "physics/held_face.h"
#include "system/contact.h"
#include "system/surface.h"

namespace furrow {

struct HeldFace {
  int kind, a, b;  // of the contact
  Face face;
};
using HeldFaces = std::vector<HeldFace>;  // sorted by (kind, a, b)

// With what it goes on into.
Rectangle whole_at(const PlatePart& plate, double t);

Face face_of(const HeldFaces& held, const ContactId& contact);

// The face after a jump; no_face if the two are further apart than the margin. at: of the disc or node; t: s, 0 while a
// scene is prepared.
Face face_after(const Parts& parts, const HeldFaces& held, const ContactId& pair, Vec2 at, double t);

// The plate that feels the body instead of pair.b; -1: none.
int felt_instead(const Parts& parts, const HeldFaces& held, const ContactId& pair, Vec2 at, double t);

// The gap to the wall or plate of the pair, as its held face has it; 0 if another plate feels the body instead.
Gap held_gap(const Parts& parts, const HeldFaces& held, const ContactId& pair, Vec2 at, double t);

// Writes into each plate where it goes on, and which others are flush with it.
void join_plates(Parts& parts);

}  // namespace furrow
