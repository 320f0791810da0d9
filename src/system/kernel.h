// The loops over contacts, one lane a contact, compiled once for each width of vector instructions. Every lane does the
// same arithmetic in the same order, so the width changes no bit.
#pragma once

#include <cstdint>

#include "system/touches.h"

namespace furrow {

// What a pair needs of each of its discs, on one line of the cache. Minus, so that one subtraction of all four gives
// the differences as in DiscPair.
struct alignas(64) PackedDisc {
  double minus_x, minus_y, vx, vy, spin, radius;
};

struct alignas(32) DiscLoad {
  double fx, fy, torque, unused;
};

// Which candidates should take a slot for a tangential spring or give theirs back.
struct Nearness {
  double margin;      // m
  std::uint32_t now;  // number of this jump
  int changed = 0;    // how many
  TouchBlock::Lanes<int> candidate{};
};

struct ContactModel {
  const ContactLaw* law;
  bool one_law;
  bool rolling;
  double lever;              // 1: arm to the contact point, 0: whole radius
  double rolling_smoothing;  // rad/s
};

struct Kernel {
  const char* name;

  // Fills the block with those of the candidates [first, last), at most as many as it holds, that overlap. `nearness`,
  // if given, takes note of who is near.
  void (*narrow)(TouchBlock&, Candidates&, int first, int last, const PackedDisc*, Nearness* nearness);

  // Runs the contact law over the block; `returning`: with the springs returned to the Coulomb limit.
  void (*evaluate)(TouchBlock&, const ContactModel&, bool returning);

  // Adds the loads of a block of disc pairs to those of the discs, in the order of the pairs.
  void (*add)(const TouchBlock&, DiscLoad*);
};

// The widest that the processor knows, or what the environment variable FURROW_VECTORS names: none, avx2, avx512.
const Kernel& kernel();

}  // namespace furrow
