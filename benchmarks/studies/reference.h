// What methods are compared with: two runs of a case by unrelated methods, and how long a scene is predictable at all.
#pragma once

#include "benchmarks/studies/measured_run.h"
#include "report/numbers.h"

namespace furrow::benchmarks {

struct Reference {
  Outcome outcome;       // of rk4 with short steps
  std::string other;     // the unrelated method
  Error disagreement{};  // of the two
  // An error is plotted, and quoted, only down to here.
  Error floor() const { return {10 * disagreement.place, 10 * disagreement.force}; }
};

// By rk4 and the case's other method. Throws Divergence if one of them does not come to the end.
Reference make_reference(const CaseInfo& info, const Case& scene);

// A run and one whose start is off by 1e-12 of each position, by the paper's method with short steps: seconds from the
// start until they differ by more than 1e-9, 1e-6, 1e-3 of how far bodies got (null: never), and by how much the
// nudge has grown at the end of the case.
Json predictability(const CaseInfo& info, const Case& scene);

}  // namespace furrow::benchmarks
