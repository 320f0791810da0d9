// What scripts/rivals, scripts/track and scripts/scale have measured. Nothing is measured here: times are taken by these
// alone, in turn with what they are compared with.
#pragma once

#include "report/measurement.h"

namespace furrow::benchmarks {

// One result for each file of benchmarks/results, under the file's name; of the list of commits, track.jsonl, an array.
// Each is as old as its file says; throws FileError if there is none at all.
void measure_speed(Measurement& measurement);

}  // namespace furrow::benchmarks
