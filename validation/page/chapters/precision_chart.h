// The chart of one case: error against cost, own methods each, Boost.Odeint's by family.
#pragma once

#include "benchmarks/studies/work_precision_curve.h"
#include "report/study.h"

namespace furrow::validation {

// `paper`: the paper's setting, a star; may be null.
Figure precision_chart(const CaseInfo& info, const std::vector<benchmarks::WorkPrecisionCurve>& method_curves,
                       double floor, const benchmarks::WorkPrecisionPoint* paper,
                       const std::vector<std::string>& winners);

}  // namespace furrow::validation
