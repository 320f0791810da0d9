// What further sentences of the paper say, computed from the curves, tears and snapshots of a run.
#pragma once

#include "validation/page/observables.h"

namespace furrow::validation {

// Empty if it is not one of these:
//   links_torn            how many links tear within the window
//   first_tear_row        row of the upper node of the first torn link, counted from 1
//   first_contact_fx_change, first_contact_fy_change   N, mean magnitude in the second half of the first contact less
//                         that in the first half
//   second_contact_order  mm, by which the largest Fy of the second contact comes after its largest Fx
//   split_after_fy        mm, by which the lattice is in two after the largest Fy of the second contact
//   contacts_per_100      stretches with a force per 100 mm, between stretches without one
//   proportional          correlation of the magnitudes of Fx and Fy over the window
//   mean_rise             mean force in the second half of the window over that in the first
//   fy_appears            N, mean magnitude of Fy in 30 mm after the plate meets the lattice less that in 30 mm before
//   largest_before_split  mm, by which the largest force comes before the lattice is in two
//   bent_at_second        mm, how far the rightmost end of a link has moved in the second snapshot
//   bent_more             mm, how much farther in the last but one than in the second
//   corner_relief_second, corner_relief_third   mean stress of the lower left corner there, over that in the first
//   lower_part_leans      mm, by which the highest end of the links that hang together with the lowest one lies beside it
//                         in the last snapshot
std::optional<Measured> measure_sentences(const RunRecord& run, const std::string& observable,
                                          const std::array<double, 2>& window);

const std::vector<std::string>& sentence_observable_names();

}  // namespace furrow::validation
