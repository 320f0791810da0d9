// The contacts that touch, as arrays, in blocks: the geometry of one kind of contact fills a block, the contact law
// runs over it lane by lane, and whoever asked sums up what he needs. One block fits the first-level cache.
#pragma once

#include <array>

#include "physics/contact.h"
#include "system/search.h"

namespace furrow {

struct TouchBlock {
  static constexpr int capacity = 128;  // a multiple of `lanes`
  static constexpr int lanes = 8;       // of the widest vectors: loops run to the next multiple, their ends are unused
  template <class T>
  using Lanes = std::array<T, capacity>;

  // Of two discs: differences b - a of position (m), a - b of velocity (m/s); spin (rad/s) and radius (m) of each.
  // It is itself the difference of what the two bring: -x, -y, vx, vy, spin, radius, 0, 0 the first of a pair and
  // -x, -y, vx, vy, 0, 0, -spin, -radius the second. One line of the cache each.
  struct alignas(64) DiscPair {
    double dx, dy, vx, vy, spin_a, radius_a, spin_b, radius_b;
  };

  ContactKind kind = disc_disc;
  int count = 0;
  Lanes<int> a{}, b{}, law{};
  Lanes<int> load_of_b{};                            // disc-disc: where the load of b is summed: b, or a spill
  Lanes<int> slot{};                                 // of the tangential spring; -1: none
  Lanes<int> segment{};                              // disc-lattice: index into Parts::border
  alignas(64) Lanes<double> touching{};              // 1, or 0 and then all forces are 0
  alignas(64) Lanes<DiscPair> pair{};                // disc-disc: what the geometry below is made from
  alignas(64) Lanes<double> share{};                 // disc-lattice: 0 at node a of the segment, 1 at node b
  alignas(64) Lanes<double> nx{}, ny{};              // unit vector from a to b
  alignas(64) Lanes<double> overlap{};               // m
  alignas(64) Lanes<double> vx{}, vy{};              // m/s, velocity of a against b at the contact, without spins
  alignas(64) Lanes<double> spin_a{}, spin_b{};      // rad/s
  alignas(64) Lanes<double> radius_a{}, radius_b{};  // m
  alignas(64) Lanes<double> arm_a{}, arm_b{};        // m, from the centre to the contact point
  alignas(64) Lanes<double> reduced_radius{}, reduced_mass{}, spring{};
  alignas(64) Lanes<double> approach{}, slip{};  // m/s
  // Results: of the law, see TouchForce; on a: force, N, -Fn n + Ft t with the tangent t = (-ny, nx); on a and b:
  // torque, N m.
  alignas(64) Lanes<double> elastic{}, normal{}, tangential{}, moment{};
  alignas(64) Lanes<double> stiffness{}, shear_stiffness{}, shear_viscosity{};
  alignas(64) Lanes<double> fx{}, fy{}, torque_a{}, torque_b{};

  // Leaves only the pairs of discs that touch.
  void keep_touching();

  double force_x(int k) const { return fx[k]; }
  double force_y(int k) const { return fy[k]; }
};

// J, in the normal and the tangential spring of contact k.
inline double stored_energy(const TouchBlock& c, int k) {
  return elastic_energy(c.elastic[k], c.overlap[k]) + 0.5 * c.shear_stiffness[k] * c.spring[k] * c.spring[k];
}

}  // namespace furrow
