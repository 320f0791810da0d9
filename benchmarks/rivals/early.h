// Whether programs agree before the bed is chaotic: the push on the plate, row by row, at two steps.
#pragma once

#include <nlohmann/json.hpp>

#include "benchmarks/rivals/rivals.h"

namespace furrow::benchmarks {

inline constexpr double early = 0.05;                  // s
inline constexpr double early_steps[] = {1e-4, 1e-5};  // s

// What an engine must show without friction to be ranked. Its force goes to furrow's with the order of the step, 1 where
// forces depend on velocities; a part of order 2 that takes 0.44 of the error away at 1e-4 s makes 0.75 of it. At 1e-5 s it is
// this near.
inline constexpr double least_early_order = 0.75, most_early_error = 1e-3;
bool agrees_early(const nlohmann::ordered_json& of_each_friction);

// Of each friction: {"friction": 0, "errors": [9e-3, 9e-4], "order": 1}; errors over the greatest push. With friction
// they are what another law and another arm make.
nlohmann::ordered_json early_agreement(const Bed& bed, const Rival& rival);

}  // namespace furrow::benchmarks
