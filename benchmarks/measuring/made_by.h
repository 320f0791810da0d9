// Who measured: written into every file of benchmarks/results, so that the page can say how old its times are.
#pragma once

#include "report/numbers.h"

namespace furrow::benchmarks {

inline Json made_by() { return json_of(this_maker(that_decide("times"))); }

}  // namespace furrow::benchmarks
