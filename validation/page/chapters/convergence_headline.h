// What the first screen of the page says of convergence: the finding, and its figure.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "validation/studies/convergence.h"

namespace furrow::validation {

// The largest force of a case.
struct ConvergedForce {
  ConvergenceCase c;
  double at_papers = NAN, finest = NAN;  // N, with the paper's step and with the finest
  Json by_step;                          // step ms, N
  std::vector<double> sound{};           // N, at the finer steps by which the method makes less than all that energy
  bool settles = true;                   // at some step
  double made = 0;                       // of all the energy that the scene was given, by the paper's step
  double off() const { return std::fabs(at_papers / finest - 1); }
};

// settled: how many numbers do not depend on the paper's step, of how many.
void add_headline(Report& report, const std::vector<ConvergedForce>& found, std::pair<int, int> settled,
                  const std::string& finest_step);

// Whole newtons from 100 on: "1135", not "1.13e+03".
std::string rounded(double force);

}  // namespace furrow::validation
