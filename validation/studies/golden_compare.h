// A run beside its golden: what was compared, and the first difference. See golden.h.
#pragma once

#include <string>

#include "report/study.h"

namespace furrow::validation {

inline constexpr int golden_format = 2;           // checkpoints with energies, and the text of the scene
inline constexpr double golden_row_every = 0.05;  // s, between rows of the force curve
inline constexpr double first_checkpoint = 0.1;   // s, after the one at the start

// How much of a golden a run can be held against: all of it, or what comes up to the first checkpoint.
enum class Extent { whole, to_first_checkpoint };

struct Comparison {
  bool same = false;
  std::string text;  // if the same, what was compared; else what is wrong first
};

// Why a golden is none, whatever it is compared with: too little in it, a number that is not finite or not a number,
// times out of order, a seal that is broken. Empty if it is one.
std::string malformed_golden(const Json& golden);

// Every number is compared to the bit: the scene, state hashes and energies at checkpoints, the force curve, tears,
// and positions at the end. Of a shorter run the rows up to its end, and a golden row that it lacks is a difference.
Comparison compare_golden(const Json& now, const Json& golden, Extent extent);

}  // namespace furrow::validation
