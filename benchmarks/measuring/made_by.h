// Who measured: written into every file of benchmarks/results, so that the page can say how old its times are.
#pragma once

#include "report/numbers.h"

namespace furrow::benchmarks {

inline Json made_by() { return json_of(this_maker(that_decide(sources_of_this_program(), {}))); }

}  // namespace furrow::benchmarks
