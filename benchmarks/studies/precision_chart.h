// The chart of one case: error against cost, own methods each, Boost.Odeint's by family.
#pragma once

#include "benchmarks/studies/ladder.h"

namespace furrow::benchmarks {

// `paper`: the paper's setting, a star; may be null.
Figure precision_chart(const CaseInfo& info, const std::vector<Ladder>& ladders, double floor, const Rung* paper);

}  // namespace furrow::benchmarks
