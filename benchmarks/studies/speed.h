// Parts of the study speed that are about furrow alone; each adds nothing where its script has left no result.
#pragma once

#include <filesystem>
#include <string>

#include "report/study.h"

namespace furrow::benchmarks {

inline const std::filesystem::path speed_results = "benchmarks/results";

void add_profile(Report& report);
void add_scale(Report& report);
void add_tracking(Report& report);

// Adds where a report of Google Benchmark was measured, if it is not there yet: the rows of a table may be of several
// machines.
void name_also(std::string& machines, const Json& google);

// What the page should show and nobody measured is a claim that does not hold.
void not_measured(Report& report, const std::string& what, const std::string& by);

std::string in_digits(double value, int digits);

// Of least, middle and most: "1.6 [1.56, 1.72]".
std::string spread(const Json& three);

}  // namespace furrow::benchmarks
