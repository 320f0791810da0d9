// What the paper says of its pictures, computed from the snapshots of a run.
#pragma once

#include "validation/page/observables.h"

namespace furrow::validation {

// Empty if it is not an observable of snapshots. All compare the last snapshot with the first, or look at one of them:
//   pile_up            mm, how much the highest disc has risen
//   depth_left_behind  mm, mean upper outline of the bed behind the plate, in the last, above the plate's lower edge
//   right_wall_stress  mean von Mises stress of the discs at the right end of the bed, last over first
//   corner_stress      the same of the lower left corner, over that of the whole lowest layer, in the first
//   corner_relief      mean stress of the lower left corner, last over first
//   stress_at_lattice  mean stress of the discs next to the lattice, second snapshot over first
//   upper_part_moved   mm, how far the rightmost end of a link has moved
//   lower_part_moved   mm, how far the leftmost end of a link has moved
std::optional<Measured> measure_snapshots(const RunRecord& run, const std::string& observable);

}  // namespace furrow::validation
