// The page's part about verification: the checks of the tests, and the faults that they notice.
#pragma once

#include "validation/page/evidence.h"
#include "validation/page/page.h"

namespace furrow::validation {

// How many checks failed; 0 if there are none to show.
std::size_t failed_checks(const Evidence& evidence);

// What the checks and the fault study come to. Zeros: there are none that can be shown.
struct Verdict {
  std::string trouble;  // why the checks that were given do not count; empty if they do, or none were given
  std::size_t checks = 0, requirements = 0, failed = 0, faults = 0, noticed = 0, untried = 0;
  std::size_t old = 0;  // faults that were tried before the solver, the tests or they themselves changed
};
Verdict verdict_of(const Evidence& evidence);

// HTML. Says what is missing. The checks go into the page as data, which a script shows, and beside it as checks.csv.
std::string verification_section(const Evidence& evidence, const std::string& number, Page& page);

}  // namespace furrow::validation
