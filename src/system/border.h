// What of a lattice discs touch. Its border at the start is that of the whole lattice. Where a scene has `new_faces` it
// is found again after each tear:
//
//   cell      four nodes, two by two neighbours; it is open once a structural link along one of its sides has torn.
//             What is around the lattice is open too
//   segments  each structural link that is intact and has something open beside it, and each shear link that is intact
//             and lies in an open cell
//   nodes     each node that has something open beside it and no such segment
//
// So a lattice torn in two has a whole face on either half, one that lost a corner has the link across it, and a node
// that has lost all its links goes on alone. Sides without a structural link never tear. Discs meet all of these as
// they meet the first border (system/contact.h). Which segments there are follows from the torn links alone. The energy
// that contacts gain or lose by the change is booked with the tears, and since every contact acts on both of its bodies
// alike, the change gives no momentum.
//
// Without `new_faces` a segment whose link has torn leaves only its two nodes, and nothing else comes.
#pragma once

#include <vector>

#include "system/parts.h"

namespace furrow {

// Adds all segments that a lattice may have after tears, lattice by lattice after those of the start.
void add_inner_segments(Parts& parts);

// Segments that discs touch, ascending. torn: links, ascending.
std::vector<int> touched_segments(const Parts& parts, const std::vector<int>& torn);

}  // namespace furrow
