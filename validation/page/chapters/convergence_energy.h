// What the chapter on convergence says of the energy that the method makes: one figure and one sentence a scene.
#pragma once

#include <string>
#include <vector>

#include "validation/studies/convergence.h"

namespace furrow::validation {

struct StepsOfCase {
  ConvergenceCase c;
  Json forces;        // step ms, largest force N
  std::string words;  // which of its numbers settle
};

// Of the scenes in `cases`, by the literal reading and the best one. Says so where the kept study did not book energy.
void add_energy(Report& report, const Numbers& results, const ConvergencePlan& plan,
                const std::vector<StepsOfCase>& cases);

}  // namespace furrow::validation
