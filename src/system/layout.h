// Where each number stands in the flat state:  [ x, y | vx, vy | spin | springs of contacts | ledger | angles ]
//
//   x, y, vx, vy  one number for each disc, then for each free node          m, m/s
//   spin          one for each disc, only if some contact has friction       rad/s
//   springs       one for each slot, only if some contact has friction       m
//                 and after each the turn of its rolling spring, only if
//                 some contact has one                                       rad
//                 then a few dummy slots, read as 0: for the kernel's contacts without a slot
//   ledger        energies since t = 0, only if asked for                    J
//   angles        one for each disc, its turns since the start, only if
//                 asked for: angle' = spin                                   rad
//
// The balance of energy: kinetic + gravity + loads + springs of links and contacts + link_damping + contact_viscous +
// friction_work + rolling_work + tear_energy - plate_work - stiffening is constant, but for the error of the method.
// plate_work is that of driven nodes too.
#pragma once

#include "physics/ramp.h"
#include "system/ode.h"
#include "system/parts.h"

namespace furrow {

enum Ledger { link_damping, contact_viscous, friction_work, rolling_work, tear_energy, plate_work, stiffening };
inline constexpr int ledger_entries = 7;

struct Layout {
  int bodies = 0;        // discs and free nodes
  int first_spring = 0;  // also the count of numbers that are always there
  int spring_count = 0;  // slots; a jump adds more if they do not suffice
  int slot_width = 1;    // numbers of a slot
  int dummy_slots = 0;
  bool keeps_ledger = false;
  int angles = 0;  // one for each disc, or none

  int x_of(int body) const { return body; }
  int y_of(int body) const { return bodies + body; }
  int vx_of(int body) const { return 2 * bodies + body; }
  int vy_of(int body) const { return 3 * bodies + body; }
  int spin_of(int disc) const { return 4 * bodies + disc; }
  int spring_of(int slot) const { return first_spring + slot_width * slot; }
  int turn_of(int slot) const { return spring_of(slot) + 1; }
  int first_dummy() const { return spring_of(spring_count); }
  int ledger_of(int entry) const { return first_dummy() + dummy_slots + entry; }
  int angle_of(int disc) const { return ledger_of(keeps_ledger ? ledger_entries : 0) + disc; }
  int size() const { return angle_of(angles); }
};

Layout make_layout(const Parts& parts);

State initial_state(const Parts& parts, const Layout& layout);

// A node that is fixed or driven. While a scene is prepared it stands still.
struct NodeAt {
  double x, y, vx, vy;  // m, m/s
};
inline NodeAt held_node_at(const Parts& parts, int node, double t, bool preparing) {
  const int drive = parts.node.drive[node];
  if (drive < 0 || preparing) return {parts.node.x[node], parts.node.y[node], 0, 0};
  const DrivePart& d = parts.drive[drive];
  const auto [time, share] = ramped(t, d.ramp);
  return {parts.node.x[node] + d.vx * time, parts.node.y[node] + d.vy * time, d.vx * share, d.vy * share};
}

// Position and velocity of all nodes.
struct NodeMotion {
  std::vector<double> x, y, vx, vy;  // m, m/s
};
NodeMotion nodes_at_rest(const Parts& parts);
void move_nodes(const Parts& parts, const Layout& layout, double t, bool preparing, const State& y, NodeMotion& nodes);

}  // namespace furrow
