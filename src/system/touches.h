// The contacts that touch, as arrays, in blocks: the geometry of one kind of contact fills a block, the contact law
// runs over it lane by lane, and whoever asked sums up what he needs. One block fits the first-level cache.
#pragma once

#include <array>

#include "physics/contact.h"
#include "system/search.h"

namespace furrow {

struct TouchBlock {
  static constexpr int capacity = 128;
  using Numbers = std::array<double, capacity>;
  using Indices = std::array<int, capacity>;

  ContactKind kind = disc_disc;
  int count = 0;
  Indices candidate, a, b, law;
  Indices segment;                         // disc-lattice: index into Parts::border
  alignas(64) Numbers share;               // disc-lattice: 0 at node a of the segment, 1 at node b
  alignas(64) Numbers nx, ny;              // unit vector from a to b
  alignas(64) Numbers overlap;             // m
  alignas(64) Numbers vx, vy;              // m/s, velocity of a against b at the contact, without spins
  alignas(64) Numbers spin_a, spin_b;      // rad/s
  alignas(64) Numbers radius_a, radius_b;  // m
  alignas(64) Numbers arm_a, arm_b;        // m, from the centre to the contact point
  alignas(64) Numbers reduced_radius, reduced_mass, spring;
  alignas(64) Numbers approach, slip;  // m/s
  // results, see TouchForce
  alignas(64) Numbers elastic, normal, tangential, moment, stiffness, shear_stiffness, shear_viscosity;

  // Force on a: -Fn n + Ft t, with the tangent t = (-ny, nx).
  double force_x(int k) const { return -normal[k] * nx[k] - tangential[k] * ny[k]; }
  double force_y(int k) const { return -normal[k] * ny[k] + tangential[k] * nx[k]; }
};

// J, in the normal and the tangential spring of contact k.
inline double stored_energy(const TouchBlock& c, int k) {
  return elastic_energy(c.elastic[k], c.overlap[k]) + 0.5 * c.shear_stiffness[k] * c.spring[k] * c.spring[k];
}

}  // namespace furrow
