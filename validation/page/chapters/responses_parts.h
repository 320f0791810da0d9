// Parts of the chapter on the simplest cases.
#pragma once

#include <string>

#include "report/study.h"

namespace furrow::validation {

// "2.5 %"
std::string percent(double share, int digits = 2);

void add_published_impacts(Report& report, const furrow::Numbers& numbers);

// Tables of verification/published; no study's numbers.
void add_published_numbers(Report& report);

}  // namespace furrow::validation
