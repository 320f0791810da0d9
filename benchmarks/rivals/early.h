// Whether programs agree before the bed is chaotic: the push on the plate, row by row, at two steps.
#pragma once

#include <nlohmann/json.hpp>

#include "benchmarks/rivals/rivals.h"

namespace furrow::benchmarks {

inline constexpr double early = 0.05;                  // s
inline constexpr double early_steps[] = {1e-4, 1e-5};  // s

// Of each friction: {"friction": 0, "errors": [9e-3, 9e-4], "order": 1}; errors over the greatest push. With friction
// they are what another law and another arm make.
nlohmann::ordered_json early_agreement(const Bed& bed, const Rival& rival);

}  // namespace furrow::benchmarks
