// Contacts in batches, one array a field: the geometry of one kind of contact fills a batch, the contact law runs over
// it lane by lane, and the caller sums up what it needs. One batch fits the first-level cache.
#pragma once

#include <array>

#include "kernel/search.h"
#include "kernel/wide.h"
#include "physics/contact.h"

namespace furrow {

struct TouchBatch {
  static constexpr int capacity = 128;  // contacts; a multiple of `lanes`
  static constexpr int lanes =
      8;  // of the widest vectors: loops run to the next multiple of it and waste the last lanes
  template <class T>
  using Lanes = std::array<T, capacity>;

  ContactKind kind = disc_disc;
  int count = 0;
  const int *a = nullptr, *b = nullptr, *slot = nullptr;  // in own_... or a list; slot of the spring, -1: none
  Lanes<int> own_a{}, own_b{}, own_slot{};
  Lanes<int> slot_or_dummy{};  // where the spring stands in the state
  Lanes<int> law{};
  Lanes<int> load_of_b{};                        // disc-disc: where the load of b goes: b, or a boundary contribution
  Lanes<int> segment{};                          // disc-lattice: index into Parts::border
  Lanes<int> near{};                             // pairs and walls: not 0 if closer than NeighbourSearch::margin
  alignas(64) Lanes<double> touching{};          // 1 or 0; where it is 0, all forces are 0
  alignas(64) Lanes<double> share{};             // disc-lattice: 0 at node a of the segment, 1 at node b
  alignas(64) Lanes<double> nx{}, ny{};          // unit vector from a to b
  alignas(64) Lanes<double> overlap{};           // m
  alignas(64) Lanes<double> vx{}, vy{};          // m/s, velocity of a against b at the contact, without spins
  alignas(64) Lanes<double> spin_a{}, spin_b{};  // rad/s
  alignas(64) Lanes<double> radius_a{}, radius_b{};  // m
  alignas(64) Lanes<double> arm_a{}, arm_b{};        // m, from the centre to the contact point
  alignas(64) Lanes<double> reduced_radius{}, reduced_mass{};
  alignas(64) Lanes<double> held{}, spring{};    // m; held: the spring before it was returned to the limit
  alignas(64) Lanes<double> approach{}, slip{};  // m/s
  // Results: of the law, see TouchForce; on a: force, N, -Fn n + Ft t with the tangent t = (-ny, nx); on a and b:
  // torque, N m.
  alignas(64) Lanes<double> elastic{}, normal{}, tangential{}, moment{};
  alignas(64) Lanes<double> stiffness{}, shear_stiffness{}, shear_viscosity{};
  alignas(64) Lanes<double> fx{}, fy{}, torque_a{}, torque_b{};
  // Of laws with options, see kernel/options.h: rad, rad/s, m/s, kg m^2; 0 of others.
  Lanes<double> turn{}, turn_held{}, turn_rate{}, spring_rate{}, rolling_inertia{};

  FURROW_WIDE int whole_lanes() const { return (count + lanes - 1) & -lanes; }  // of all vectors

  // Repeats the last pair in the lanes after it, so that these name discs that exist.
  void fill_last_lanes();

  void use_own() { a = own_a.data(), b = own_b.data(), slot = own_slot.data(); }

  // Leaves only the contacts that touch.
  void keep_touching();

  double force_x(int k) const { return fx[k]; }
  double force_y(int k) const { return fy[k]; }
};

}  // namespace furrow
