// What a sample of runs says, in words.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "validation/page/run_record.h"
#include "validation/studies/members.h"

namespace furrow::validation {

// Whether runs say yes, 1, or no, 0: those have a count and no median.
inline bool is_yes_or_no(const Statement& s) {
  return s.observable == "finished" && (!s.holds || *s.holds == std::array{1.0, 1.0});
}

// "8 of 8"
inline std::string count_of_yes(const Sample& sample) {
  return std::to_string(std::count(sample.numbers.begin(), sample.numbers.end(), 1)) + " of " +
         std::to_string(sample.members());
}

// "156 to 169", "always 0.2"
inline std::string from_to(double low, double high) {
  const bool same = std::fabs(high - low) <= 1e-12 * std::fabs(low);  // but for round-off
  return same ? "always " + three_digits(low) : three_digits(low) + " to " + three_digits(high);
}

}  // namespace furrow::validation
