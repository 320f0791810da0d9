// The loops over contacts, one lane a contact, compiled once for each width of vector instructions. Every lane does the
// same arithmetic in the same order, so the width changes no bit.
#pragma once

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
  const double* radius;           // m
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

struct Kernel {
  const char* name;

  // Fills the pairs of the block from what each disc brings as the first and as the second of a pair. The fastest, as
  // long as that stays in the cache.
  void (*pair_up)(TouchBlock&, const TouchBlock::DiscPair* first, const TouchBlock::DiscPair* second);

  // The same from the state itself.
  void (*pair_up_scattered)(TouchBlock&, const DiscMotion&);

  // Takes note of which pairs are near. True if one of them should take a slot or give it back.
  bool (*note_near)(const TouchBlock&, std::uint32_t* near_at, const Nearness&);

  // Runs the contact law over the block: slip, forces and torques. `returning`: with the springs returned to the
  // Coulomb limit; `details`: all that the block names.
  void (*evaluate)(TouchBlock&, const ContactModel&, bool returning, bool details);

  // Adds the loads of a block of disc pairs to those of the discs, in the order of the pairs.
  void (*add)(const TouchBlock&, const int* load_of_b, DiscLoad*);

  // Adds the powers of a block with details, contact by contact.
  void (*add_powers)(const TouchBlock&, bool friction, ContactPowers&);
};

// The widest that the processor knows, or what the environment variable FURROW_VECTORS names: none, avx2, avx512.
const Kernel& kernel();

}  // namespace furrow
