// The page's part about verification: the checks, and the faults that they notice.
#pragma once

#include <string>

#include "validation/page/evidence.h"

namespace furrow::validation {

// HTML. A file that is not there or cannot be used makes a sentence that says so.
std::string verification_section(const Evidence& evidence);

// 0 if there are no checks to read.
std::size_t failed_checks(const Evidence& evidence);

}  // namespace furrow::validation
