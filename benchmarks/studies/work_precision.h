// Work against precision: every method on every case, by evaluations of the right-hand side and by CPU time.
#pragma once

#include "benchmarks/studies/work_precision_curve.h"
#include "report/measurement.h"

namespace furrow::benchmarks {

constexpr double paper_step = 1e-4;  // s, with pece

std::vector<CaseInfo> work_precision_cases(bool quick);

// What is measured on a case: each method, without and with location of events.
std::vector<Variant> variants_on(const CaseInfo& info);

// Of {"other": method, "place", "force": disagreement, "torn": links}.
std::string reference_key(const CaseInfo& info);
std::string nudged_key(const CaseInfo& info);    // of predictability()
std::string spectrum_key(const CaseInfo& info);  // of the fastest decay where the chart begins, 1/s
std::string curve_key(const CaseInfo& info, const Variant& variant);

void measure_work_precision(Measurement& measurement);

}  // namespace furrow::benchmarks
