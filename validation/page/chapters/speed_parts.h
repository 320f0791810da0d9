// Parts of the chapter on speed; each says so where nothing was measured.
#pragma once

#include <string>

#include "report/study.h"
#include "scene/wording.h"

namespace furrow::validation {

void add_profile(Report& report, const Numbers& numbers);
void add_scale(Report& report, const Numbers& numbers);
void add_tracking(Report& report, const Numbers& numbers);
void add_beyond(Report& report, const Numbers& numbers);
void add_bonds(Report& report, const Numbers& numbers);

// The file's content; null if there is none.
Json measured(const Numbers& numbers, const std::string& file);

// Adds where a report of Google Benchmark was measured, if it is not there yet: the rows of a table may be of several
// machines.
void name_also(std::string& machines, const Json& google);

// What the page should show and nobody measured is a claim that does not hold.
void not_measured(Report& report, const std::string& what, const std::string& by);

// Of least, middle and most: "1.6 [1.56, 1.72]".
std::string spread(const Json& three);

}  // namespace furrow::validation
