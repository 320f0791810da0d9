// The first screen of the page: verdict, finding, a tile a question, and what does not hold.
#pragma once

#include "validation/page/page.h"
#include "validation/page/run_record.h"
#include "validation/page/studies.h"
#include "validation/page/verification.h"

namespace furrow::validation {

// HTML. All of it is computed from the runs, the evidence and what the chapters say.
std::string summary(const std::vector<RunRecord>& runs, const Evidence& evidence,
                    const std::vector<StudyResult>& studies, Page& page);

// The part of the finding that says how far the runs leave what Hertz's law holds for; empty if none does.
std::string beyond_hertz(const std::vector<RunRecord>& runs);

// A row a study: when, by which commit and machine its numbers were made, and whether the solver has changed since.
std::string ages(const std::vector<StudyResult>& studies, const Evidence& evidence, Page& page);

}  // namespace furrow::validation
