// What the study of stability measures.
#pragma once

#include <vector>

#include "report/measurement.h"

namespace furrow::verification {

// Damping ratios of the atlas.
std::vector<double> atlas_ratios(bool quick);

void measure_stability(Measurement& measurement);

}  // namespace furrow::verification
