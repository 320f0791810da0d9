// The chart of one case: error against cost, own methods each, Boost.Odeint's by family.
#pragma once

#include "benchmarks/studies/work_precision_curve.h"

namespace furrow::benchmarks {

// `paper`: the paper's setting, a star; may be null.
Figure precision_chart(const CaseInfo& info, const std::vector<WorkPrecisionCurve>& method_curves, double floor,
                       const WorkPrecisionPoint* paper);

}  // namespace furrow::benchmarks
