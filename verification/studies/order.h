// What the order certificate measures, and how its numbers are read again.
#pragma once

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "report/measurement.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/order_predicted.h"
#include "verification/studies/order_trends.h"

namespace furrow::verification {

inline constexpr std::array<double, 5> drift_angles{0.3, 0.2, 0.1, 0.05, 0.025};  // h omega

using Cell = std::pair<std::string, std::string>;  // method, problem

struct Trends {
  Count count;
  std::vector<double> drift;         // at drift_angles; none of a controlled method
  std::vector<Point> spring, hertz;  // the way back, by problem
};

struct Observations {
  std::map<Cell, std::vector<Point>> points;  // none if it failed as a whole: thus no order
  std::map<Cell, Verdict> verdicts;
  std::map<std::string, Trends> trends;                                           // by method
  std::map<std::tuple<std::string, std::string, int>, std::vector<Point>> cured;  // method, problem, grading
};

constexpr Series order_series(bool in_quick_form) { return in_quick_form ? quick : full; }

void measure_order(Measurement& measurement);

Observations observations_of(const Numbers& numbers);

}  // namespace furrow::verification
