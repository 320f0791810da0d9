// The figures of the order certificate.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "studies/order_observed.h"
#include "studies/order_predicted.h"
#include "studies/study.h"

namespace furrow::studies {

using Cell = std::pair<std::string, std::string>;  // method, problem

struct Observations {
  std::map<Cell, std::vector<Point>> points;
  std::map<Cell, Verdict> verdicts;
  std::map<Cell, std::string> failed;  // why
  std::map<std::string, Json> trends;  // by method
};

// Method by force: observed over predicted order, coloured by the observed one.
Figure matrix_figure(const Observations& all);

// Error against step, a panel for each force, for the methods that a scene would use.
Figure slopes_figure(const Observations& all);

// Change of energy a period against h omega.
Figure energy_figure(const Observations& all, const std::vector<double>& angles);

}  // namespace furrow::studies
