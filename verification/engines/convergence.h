// Where answers at several resolutions go: to the expected value, elsewhere, or nowhere.
#pragma once

#include <vector>

#include "verification/engines/judge.h"

namespace furrow::verification {

// Resolutions within this factor belong together.
inline constexpr double close_resolutions = 1.2;

// An observable whose error falls with the order of the method, or with the lowest that its case allows (`seen`: `floor`,
// `limit`, perhaps `scale`). `f` holds the values, one for each of `steps`, and what is expected. Undecided if the values
// neither arrive nor settle: at finer resolutions they may.
Finding judge_converging(Finding f, const Json& seen, const std::vector<int>& steps, double claimed);

// By what an error of this observable is divided: its `scale`, else the expected value, else 1.
double scale_of(const Json& seen, double expected);

std::string few(double value);  // three digits

}  // namespace furrow::verification
