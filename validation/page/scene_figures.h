// Figures of a scene beyond its force and energy: overlaps, the sequence of tears, where the step matters.
#pragma once

#include <string>
#include <vector>

#include "report/study.h"
#include "validation/page/page.h"
#include "validation/page/run_record.h"

namespace furrow::validation {

// The same scene by another step.
struct RunByStep {
  double step = 0;  // s
  ForceCurve force;
};

// The largest force in each stretch of the plate's way over the kept packings: between which 5 % and 95 % of them lie.
struct ForceBand {
  std::vector<double> mm, low, high;  // ends of the stretches; N
  std::size_t packings = 0;
};

// Empty if the numbers are not kept, or by an earlier form of the study.
ForceBand force_band(const Shelf& shelf, const std::string& scene);

// Each is HTML, empty where the run has nothing to show.
std::string overlap_figure(const RunRecord& run, Page& page);
std::string tear_figure(const RunRecord& run, Page& page);
// `others` holds the run itself and the same scene by other steps; the finest is what they are measured by.
std::string step_figure(const RunRecord& run, std::vector<RunByStep> others, Page& page);

}  // namespace furrow::validation
