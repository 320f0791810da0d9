// Whether the runs of an ensemble bear out a statement of the paper.
#pragma once

#include <string>

#include "validation/page/run_record.h"
#include "validation/studies/members.h"

namespace furrow::validation {

// "reproduced", "reproduced in kind", "not reproduced" or "not testable".
//
// A limit is reproduced if at least half of the members keep it, in kind if one in twenty does. A number is reproduced
// if it lies between the 5 % and 95 % quantiles or within a tenth of the median, in kind within a third of it.
std::string verdict_of(const Statement& statement, const Sample& sample);

}  // namespace furrow::validation
