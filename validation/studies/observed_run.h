// A scene run without files, as the record that the page's observables are computed from.
#pragma once

#include "report/measurement.h"
#include "run/prepare.h"
#include "validation/page/observables.h"

namespace furrow::validation {

// From a scene made ready to scene.time.end, by scene.time's method and step; the force every scene.output.interval.
// A run that diverges keeps what it has: fact "ended" is then "diverged", fact "reason" says why.
// Watched, as `furrow run` does it, a run also ends where it leaves the validity of its laws.
enum class Watch { off, on };
RunRecord observed_run(Prepared prepared, const Timing& time, Watch watch = Watch::off);

// The named observables of the paper's statements about `scene` ("scenario_1" ...), in the order of statements.toml;
// NaN where the run does not say, or says it in words.
struct Reported {
  std::string id;
  Measured ours;
};
std::vector<Reported> reported(const RunRecord& run, const Publication& paper, const std::string& scene);

// validation/statements.toml.
const Publication& the_paper();

// Of a scene and of what the statements ask of it, not of their words: what goes into the numbers of an observed run.
std::string hash_of_observed(const Scene& made, const std::string& scene);

}  // namespace furrow::validation
