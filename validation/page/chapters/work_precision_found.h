// What is kept of a case of the work-precision study, and what follows from it.
#pragma once

#include <cmath>
#include <string>

#include "benchmarks/studies/work_precision.h"
#include "report/study.h"

namespace furrow::validation {

struct Found {
  CaseInfo info;
  Json reference, foretold, fastest;
  std::vector<benchmarks::WorkPrecisionCurve> method_curves;
};
Found found_in(const Numbers& numbers, const CaseInfo& info);

struct Cheapest {
  std::string method;
  double cost = NAN;
};
// The method without the marks behind its name: the first screen comes before their explanation.
std::string spelt_out(const std::string& method);
Cheapest cheapest_at(const Found& found, double error, double benchmarks::WorkPrecisionPoint::*cost);

const benchmarks::WorkPrecisionCurve& paper_curve(const Found& found);

// The paper's method at the paper's step, or nothing if that failed.
const benchmarks::WorkPrecisionPoint* paper_point(const Found& found);

// The references do not distinguish errors below. NaN if one of them failed.
double floor_of(const Found& found);

// The best of all methods in each problem, in one figure, beside the paper's setting.
void add_summary(Report& report, const std::vector<Found>& all);
// What failed and what was not run: all methods and all scenes in two tables.
void add_failures(Report& report, const std::vector<Found>& all);
void add_references(Report& report, const std::vector<Found>& all);
void add_predictability(Report& report, const std::vector<Found>& all);

}  // namespace furrow::validation
