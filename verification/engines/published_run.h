// furrow's own numbers for the problems that others have published, see verification/published.
#pragma once

#include <map>
#include <string>

#include "verification/engines/case.h"

namespace furrow::verification {

// A problem of a file of verification/published, as plain_case_from reads it, as a case for any engine: what it is called,
// `end` (s), `steps` up to there and its bodies as in a case, its rows as what is observed; of one that names a case, that.
// Throws std::invalid_argument.
Json case_of_problem(const Json& problem);

// By name of the row, in its SI unit: the solver's by rk4 with the problem's steps, of a case with its finest.
// Throws std::invalid_argument for a problem that furrow cannot run.
std::map<std::string, double> furrows_numbers(const Json& problem);

}  // namespace furrow::verification
