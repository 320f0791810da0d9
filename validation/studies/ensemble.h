// The paper shows one run of each scene. How much of what it reports is the run's packing? Its scenes over many packings;
// and its second scene with a constant of the model changed, to see how few packings notice that.
#pragma once

#include <string>
#include <vector>

#include "validation/studies/members.h"

namespace furrow::validation {

// The observables by which a changed model is noticed.
inline const std::vector<std::string> few_observables{"surface", "mean_force", "largest_force_discs", "force_ratio"};

struct Change {
  std::string what;
  double factor;
  void (*apply)(Scene&, double factor);
  std::string key(int member) const;
};
const std::vector<Change>& changes();
inline constexpr int changed_members = 8;

// Every key of the study in that form: the members', then the changes'.
std::vector<std::string> ensemble_keys(bool quick);

void measure_ensemble(Measurement& measurement);

}  // namespace furrow::validation
