// Two builds side by side.
#pragma once

#include "benchmarks/tracking/counts.h"

namespace furrow::benchmarks {

// Runs each kernel of both builds in turn, and the base a second time, whose difference from itself is the noise floor.
// Exit code of track.cpp; an answer that differs is reported, and its kernel not compared.
int compare(const Build& build, const Build& base, int rounds);

}  // namespace furrow::benchmarks
