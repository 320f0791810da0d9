// One contact that touches, from its geometry to its forces, as a solver passes it to observers.
//
// The tangent is t = (-ny, nx). Body a gets the force -Fn n + Ft t, body b the opposite, shared by the two nodes of a
// border segment as 1 - share and share.
//
//   kind          R*               m*                                arms of a, b        n
//   disc-disc     Ra Rb/(Ra + Rb)  ma mb/(ma + mb)                   Ra - d/2, Rb - d/2  between the centres
//   disc-wall     Ra               ma                                Ra - d              against the wall's normal
//   disc-plate    Ra               ma                                Ra - d              to the nearest point
//   disc-lattice  Ra               1/(1/ma + (1 - s)^2/mi + s^2/mj)  Ra - d              to the contact point
//   node-wall     contact_radius   ma                                0                   against the wall's normal
//   node-plate    contact_radius   ma                                0                   to the nearest face
//
// n points from a to b. Its length is 1, but of a kept face of a plate it is shorter in the corners
// (physics/held_face.h). Of a centre inside a plate it is the inward normal of the nearest face, or of the kept one; of
// one on the far side of a border the direction to the contact point. Fixed and driven nodes have an infinite mass. With
// `moment_arm = "radius"` an arm is the whole radius, with `half_overlap` R - d/2 of all kinds, as in LIGGGHTS.
//
// Only discs spin. A lattice is of point masses, which have no spin: a disc rolls on it with w = omega_a, also where the
// segment turns, and the rolling moment has no reaction on the nodes. So rolling friction on a lattice keeps linear
// momentum, not angular momentum (tests/expected_to_fail). A reaction as a couple of forces on the two nodes would jump
// from node to node, each time a disc rolls on to the next segment.
#pragma once

#include <array>
#include <string>

#include "physics/contact_force.h"
#include "system/parts.h"

namespace furrow {

enum ContactKind { disc_disc, disc_wall, disc_plate, disc_lattice, node_wall, node_plate };
inline constexpr int contact_kinds = 6;
inline constexpr std::array<const char*, contact_kinds> contact_kind_names{"disc-disc",    "disc-wall", "disc-plate",
                                                                           "disc-lattice", "node-wall", "node-plate"};

constexpr bool of_disc(ContactKind kind) { return kind <= disc_lattice; }
constexpr bool of_wall(ContactKind kind) { return kind == disc_wall || kind == node_wall; }
constexpr bool of_plate(ContactKind kind) { return kind == disc_plate || kind == node_plate; }

struct ContactId {
  ContactKind kind = disc_disc;
  int a = -1, b = -1;  // disc or node; disc, wall, plate or lattice; -1: none
};

struct Contact {
  ContactId id;
  int law = 0;            // index into Parts::law
  int slot = -1;          // of the tangential spring in the state; -1: none
  int segment = -1;       // disc-lattice: index into Parts::border
  double share = 0;       // -, disc-lattice: 0 at node a of the segment, 1 at node b
  double nx = 0, ny = 0;  // n, from a to b
  double arm_a = 0;       // m, from the centre to the contact point
  double arm_b = 0;       // m, of disc b
  double vx = 0, vy = 0;  // m/s, of a against b at the contact, without spins
  double spin_a = 0;      // rad/s
  double spin_b = 0;      // rad/s
  Touch touch{};          // what the law sees
  TouchForce force{};     // what it answers
  double fx = 0, fy = 0;  // N, on a
  double torque_a = 0;    // N m
  double torque_b = 0;    // N m, on disc b
};

// J, in the springs of a contact.
inline double stored_energy(const Parts& parts, const Contact& c) {
  return stored_energy(parts.law[c.law], c.touch, c.force);
}

// kg m^2, Ir of physics/rolling_spring.h.
double rolling_inertia(const Parts& parts, const ContactId& pair);

// "disc 3 and wall 0", "disc 3 and lattice stem": the two parts in contact; empty for no contact.
std::string contact_name(const Parts& parts, const ContactId& contact);

}  // namespace furrow
