// A regression test on few packings: does a bed that was packed again still behave like the ensemble? For changes that
// move bits on purpose, so that the golden outputs cannot judge them.
#pragma once

#include "validation/studies/ensemble.h"

namespace furrow::validation {

inline constexpr int few = 5;           // members that are run
inline constexpr double few_limit = 4;  // standard errors that the mean of a few may lie from the ensemble's

// Of the ensemble: mean and standard deviation of each of few_observables.
struct Norm {
  std::vector<double> mean, deviation;
};
Norm norm_of(const std::vector<Json>& ensemble);

// The largest distance of the few members' means from the norm, in their standard errors; infinite if a member or the
// norm does not say.
double strangeness(const std::vector<Json>& members, const Norm& norm);

// How often `few` of the members that came to their end, drawn at random (seeded, without replacement), look strange; 1
// if there are fewer. A member that does not come to its end is no matter of chance: it is counted separately.
double alarm_rate(const std::vector<Json>& members, const Norm& norm, int draws);

// Runs a few packings that are not in the ensemble and compares them with its result in settings.directory, a line an
// observable. Returns whether they are like it. Throws FileError if there is no result to compare with (see
// kept_ensemble), Interrupted.
bool check_few(const Settings& settings, const std::function<void(const std::string&)>& say);

}  // namespace furrow::validation
