// The loops over contacts and discs, one lane each, at the widest vectors of the processor.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernel/touches.h"

namespace furrow {

struct alignas(32) DiscLoad {
  double fx, fy, torque, unused;
};

// Position and velocity of a disc, side by side: a pair takes them by one load each.
struct alignas(32) DiscRow {
  double x, y, vx, vy;  // m, m/s
};

// What contacts take of their discs.
struct DiscMotion {
  const DiscRow* row;
  const double* spin;    // rad/s; null: none
  const double* radius;  // m; null: all alike, the block has it
  double lever;          // 1: arm to the contact point, 0: whole radius
  double margin;         // m, see NeighbourSearch
};

struct ContactModel {
  const ContactLaw* law;
  bool one_law;
  bool rolling;
  double rolling_smoothing;  // rad/s
};

// What the loads of the discs do to them; m/s^2, rad/s^2.
struct DiscRates {
  double *ax, *ay, *turning;  // turning null: they do not spin
  const double *inverse_mass, *weight, *inverse_inertia;
};

// The rows of the discs [first, last).
void line_up(const double* x, const double* y, const double* vx, const double* vy, DiscRow*, std::size_t first,
             std::size_t last);

// Where the pairs of the block touch, to the end of its last vector; where its discs touch their walls.
void pair_up(TouchBlock&, const DiscMotion&);
void meet_walls(TouchBlock&, const DiscMotion&, const WallPart*);

// Of the contacts of a block of disc pairs or walls that touch: how many, the greatest overlap, of the smaller radius,
// and the greatest approach (m/s).
struct BlockExtremes {
  double contacts = 0, overlap = 0, approach = 0;
};
BlockExtremes extremes(const TouchBlock&);

// Takes note of which contacts are near at jump `now`. True if one of them should take a slot or give it back.
bool note_near(const TouchBlock&, std::uint32_t* near_at, std::uint32_t now);

// Runs the contact law over a filled block: slip, forces and torques. `returning`: with the springs returned to the
// Coulomb limit; `details`: all that the block names.
void evaluate(TouchBlock&, const ContactModel&, bool returning, bool details);

// Takes the springs of the block from those of the state, the spare one for contacts without a slot, and puts numbers
// of the block where these stand.
void take_springs(TouchBlock&, const double* spring, int spare);
void put_by_place(const TouchBlock&, const TouchBlock::Lanes<double>&, double* by_place);

// Puts the springs of a block back that was evaluated with them returned. True if one has changed.
bool put_returned(const TouchBlock&, double* spring);

// Adds the loads of a block of disc pairs to those of the discs, in the order of the pairs.
void add_loads(const TouchBlock&, const int* load_of_b, DiscLoad*);

// Adds the powers of a block with details, contact by contact.
void add_powers(const TouchBlock&, bool friction, ContactPowers&);

// The rates of the discs [first, last).
void accelerate(const DiscLoad*, const DiscRates&, std::size_t first, std::size_t last);

}  // namespace furrow
