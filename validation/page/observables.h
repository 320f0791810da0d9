// The numbers that the paper reports, computed from the files of a run.
#pragma once

#include "validation/page/run_record.h"

namespace furrow::validation {

// A number, or words where a number will not do. NaN without words: the run does not say.
struct Measured {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string words = {};
};

// The observable of that name over a window of plate displacement (mm), by default the whole run. Throws
// std::invalid_argument if there is no such observable.
Measured measure(const RunRecord& run, const std::string& observable, std::optional<std::array<double, 2>> window = {});

// All that there are.
const std::vector<std::string>& observable_names();

// Largest sum of forces in each whole stretch of `length` mm: {where (mm), how large (N)}.
std::vector<std::array<double, 2>> maxima(const ForceCurve& curve, double length);

// Whether one end of the link, and only one, is fixed.
bool half_fixed(const Parts& lattices, int link);

}  // namespace furrow::validation
