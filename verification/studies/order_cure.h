// What restores the order that a touch takes: a step that ends at the touch, and after it steps that grow.
//
//   t - t0 = T (n/N)^g
//
// The force after the touch goes as (t - t0)^a. Located (g = 1) the step after it still errs by h^(a + 1) if a is no
// whole number; graded steps make that N^(-g (a + 1)): order min(p, g (a + 1)) in 1/N. A jump or a kink (a = 0, 1) is
// smooth once the step ends at it: order p for any g.
#pragma once

#include <array>
#include <vector>

#include "methods/method.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/order_problems.h"

namespace furrow::verification {

// The methods of the catalogue whose formulas hold for unequal steps.
inline constexpr std::array<const char*, 6> graded_methods{"pece", "pec", "pecece", "ab2", "verlet", "rk4"};
inline constexpr std::array<const char*, 4> graded_problems{"linear_contact", "dashpot_contact", "hertz_inside",
                                                            "damped_hertz_inside"};
inline constexpr std::array<int, 3> gradings{1, 2, 4};

// From the touch to the middle of the contact; the step of a point is the mean one.
std::vector<Point> observe_graded(const std::string& method, const Problem& problem, int grading, const Series& series);

double predicted_graded(const MethodInfo& method, const Problem& problem, int grading);

}  // namespace furrow::verification
