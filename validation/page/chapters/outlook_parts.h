// Parts of the chapter on what the paper leaves to later.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "validation/studies/members.h"
#include "validation/studies/outlook.h"

namespace furrow::validation {

struct Estimate {
  double mean = NAN, half = NAN;  // half the 95 % interval
  Estimate(const std::string& id, const std::vector<Json>& members);
  // Both to the same decimal, the second of the half interval.
  std::string text() const;
};

// Whether the study has all runs of the variation; those of a later form are not in one that was kept before.
bool measured(const Numbers& numbers, const OutlookVariation& variation);

// Which parameter moves what: the exponent n of force ~ parameter^n, by packings.
void add_sensitivity(Report& report, const Numbers& numbers);

// The tool that bends beside the rigid one.
void add_tools(Report& report, const Numbers& numbers);

}  // namespace furrow::validation
