// Lattices that reach through each other, through themselves, or through a plate: a plate meets nodes alone, so a narrow one
// can go between two of them, through the border segment that joins them.
#pragma once

#include "run/crossing.h"

namespace furrow {

// Whole border segments that go through a plate, in by one side and out by the opposite one, and of what the first are. One
// that goes round a corner of a plate, as that of a bent lattice may, is none.
CrossingBorders cut_by_plates(const System& system, double t, const State& y);

// All of it: borders that cross each other, cells that are inside out, borders that plates cut.
CrossingBorders standing_crossings(const System& system, double t, const State& y);

// m: the least way on which one of these may come and go, where there is a lattice.
double least_crossing_way(const Parts& parts);

}  // namespace furrow
