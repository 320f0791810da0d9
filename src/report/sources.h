// Which sources a number depends on: a hash of each file, without comments and blanks.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace furrow {

using Sources = std::map<std::string, std::string>;  // path in the project: hash

// Of the solver and of the studies, as this program was built from them.
const Sources& sources_of_this_program();

// Those that decide the numbers of a study: the state path (physics, system, reference, kernel, methods, run and what
// makes the start of a scene), and the study's own files, each given by the beginning of its path. The watches of
// src/run look on, and may end a run: they decide what is `watched`, results that say whether and why a run was ended.
Sources that_decide(const Sources& all, const std::vector<std::string>& own, bool watched = false);

// The same for what is kept and is no study. Throws std::invalid_argument that lists what there is.
//   "faults"              verdicts of the fault study: the solver, and all that its tests call
//   "judged_furrow"       what the judge says of furrow: the solver and the judge
//   "judged_independent"  of the engine that shares nothing with it: this engine and the judge
//   "judged_others"       of other programs: the judge and the small programs that ask them
//   "times"               the solver
Sources that_decide(const std::string& what);

// The files that have changed since something was made by the sources `then`, of those that decide it `now`; sorted.
std::vector<std::string> changed_since(const Sources& then, const Sources& now);

// The files that are not the same in both, or are in one alone; sorted.
std::vector<std::string> differing(const Sources& a, const Sources& b);

}  // namespace furrow
