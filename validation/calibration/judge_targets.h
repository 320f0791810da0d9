// What the parts of a file of targets say together: values against tolerances, and targets against each other.
#pragma once

#include "validation/calibration/targets.h"

namespace furrow::validation {

// Within these a misfit is finite and is not lost against others.
constexpr double least_tolerance = 1e-12, most_tolerance = 1e12;  // in the unit of the observable
constexpr double least_of_value = 1e-9, most_of_value = 1e9;      // a tolerance over the value
constexpr double least_weight = 1e-6, most_weight = 1e6;
constexpr double least_missing = 1, most_missing = 1e6;  // tolerances

// What is wrong with the tolerance of a target whose value is read; empty if nothing is.
std::string fault_of_tolerance(const CalibrationTarget& target);

// Two targets that are one, two that share a name, scenes without a target.
std::vector<std::string> faults_between(const std::vector<CalibrationTarget>& targets,
                                        const std::vector<std::string>& scenes);

}  // namespace furrow::validation
