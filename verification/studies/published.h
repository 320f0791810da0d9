// Methods by published problems, as numbers.
#pragma once

#include "methods/method.h"
#include "report/measurement.h"
#include "verification/studies/published_problems.h"

namespace furrow::verification {

// Of {"cannot": why}, or {"slope": null if none stands above round-off, "error": the least, "holds", "known": to fail}.
std::string published_key(const MethodInfo& method, const PublishedProblem& problem);

void measure_published(Measurement& measurement);

}  // namespace furrow::verification
