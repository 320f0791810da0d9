// The figures of the order certificate.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "report/study.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/order_predicted.h"

namespace furrow::verification {

using Cell = std::pair<std::string, std::string>;  // method, problem

struct Observations {
  std::map<Cell, std::vector<Point>> points;
  std::map<Cell, Verdict> verdicts;
  std::map<std::string, Json> trends;                                             // by method
  std::map<std::tuple<std::string, std::string, int>, std::vector<Point>> cured;  // method, problem, grading
};

// Method by force: observed above predicted order, coloured by the observed one.
Figure matrix_figure(const Observations& all, bool of_velocity);

std::string fixed(double value, int digits);
std::string shown_order(double order);  // 2, 2.5, 1.25

// Error against step, a panel for each force, for the methods that a scene would use.
Figure slopes_figure(const Observations& all);

// Change of energy a period against h omega.
Figure energy_figure(const Observations& all, const std::vector<double>& angles);

}  // namespace furrow::verification
