// The loops over contacts and discs, one lane each, at the widest vectors of the processor.
#pragma once

#include <cstddef>
#include <cstdint>

#include "system/touches.h"

namespace furrow {

struct alignas(32) DiscLoad {
  double fx, fy, torque, unused;
};

// One number a disc.
struct DiscMotion {
  const double *x, *y, *vx, *vy;  // m, m/s
  const double* spin;             // rad/s; null: none
  const double* radius;           // m; null: all alike, the block has it
};

// When a candidate should take a slot for a tangential spring or give it back.
struct Nearness {
  double margin = 0;      // m
  std::uint32_t now = 0;  // number of this jump; the first is 1, so that 0 is no jump
};

struct ContactModel {
  const ContactLaw* law;
  bool one_law;
  bool rolling;
  double lever;              // 1: arm to the contact point, 0: whole radius
  double rolling_smoothing;  // rad/s
};

// Powers (W) by cause.
struct ContactPowers {
  double viscous, friction, rolling, stiffening;
};

// What the loads of the discs do to them; m/s^2, rad/s^2.
struct DiscRates {
  double *ax, *ay, *turning;  // turning null: they do not spin
  const double *inverse_mass, *weight, *inverse_inertia;
};

// Fills the pairs of the block.
void pair_up(TouchBlock&, const DiscMotion&);

// Takes note of which pairs are near. True if one of them should take a slot or give it back.
bool note_near(const TouchBlock&, std::uint32_t* near_at, const Nearness&);

// Runs the contact law over the block: slip, forces and torques. `returning`: with the springs returned to the
// Coulomb limit; `details`: all that the block names.
void evaluate(TouchBlock&, const ContactModel&, bool returning, bool details);

// Adds the loads of a block of disc pairs to those of the discs, in the order of the pairs.
void add_loads(const TouchBlock&, const int* load_of_b, DiscLoad*);

// Adds the powers of a block with details, contact by contact.
void add_powers(const TouchBlock&, bool friction, ContactPowers&);

// The rates of the discs [first, last).
void accelerate(const DiscLoad*, const DiscRates&, std::size_t first, std::size_t last);

}  // namespace furrow
