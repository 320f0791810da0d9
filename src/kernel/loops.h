// The loops over contacts and discs, one of them a lane, at the widest vectors of the processor.
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

// What the contacts of discs need to know of them.
struct DiscMotion {
  const DiscRow* row;
  const double* spin;                       // rad/s; null: none
  const double* radius;                     // m; null: all are equal and stand in the batch
  double pair_shortening, flat_shortening;  // -, of the moment arms, see Parts
  double margin;                            // m, see NeighbourSearch
};

struct ContactModel {
  const ContactLaw* law;
  bool one_law;
  bool rolling;
  double rolling_smoothing;  // rad/s
};

// Where the accelerations of the discs go (m/s^2, rad/s^2), and what they are computed from.
struct DiscRates {
  double *ax, *ay, *turning;  // turning null: they do not spin
  const double *inverse_mass, *gravity, *inverse_inertia;
};

// Writes the rows of the discs [first, last).
void interleave(const double* x, const double* y, const double* vx, const double* vy, DiscRow*, std::size_t first,
                std::size_t last);

// Geometry and kinematics of the batch's pairs of discs, or of its discs and their walls, to the end of its last
// vector.
void locate_pairs(TouchBatch&, const DiscMotion&);
void locate_walls(TouchBatch&, const DiscMotion&, const WallPart*);

// Of a batch of disc pairs or of discs and walls: the number of contacts that touch, their greatest overlap (as a
// fraction of the smaller radius) and their greatest approach (m/s).
struct BatchExtremes {
  double contacts = 0, overlap = 0, approach = 0;
};
BatchExtremes extremes(const TouchBatch&);

// Records which contacts are near at jump `now`. True if one of them should take a slot or give it back.
bool note_near(const TouchBatch&, std::uint32_t* near_at, std::uint32_t now);

// Runs the contact law over a filled batch: slip, forces and torques.
struct Evaluation {
  bool returning;   // springs are first returned to the Coulomb limit
  bool all_fields;  // of the batch: also those that only the ledger and observers need
};
void evaluate(TouchBatch&, const ContactModel&, Evaluation);

// Reads the springs of the batch from the state; writes numbers of the batch to the same places. `dummy` is the slot
// for contacts that hold none.
void gather_springs(TouchBatch&, const double* spring, int dummy);
void scatter_to_slots(const TouchBatch&, const TouchBatch::Lanes<double>&, double* by_slot);

// Writes back the springs that `evaluate` has returned to the limit.
struct Returned {
  bool changed;  // some spring
  bool stirred;  // one of a contact that does not touch: it did within the step
};
Returned scatter_returned(const TouchBatch&, double* spring);

// Adds the loads of a batch of disc pairs to those of the discs, in the order of the pairs.
void add_loads(const TouchBatch&, const int* load_of_b, DiscLoad*);

// Adds the powers of a batch evaluated with all fields, contact by contact.
void add_powers(const TouchBatch&, bool friction, ContactPowers&);

// The accelerations of the discs [first, last).
void accelerate(const DiscLoad*, const DiscRates&, std::size_t first, std::size_t last);

}  // namespace furrow
