// furrow's own run from the start of a deck, with rows as the deck writes them.
#pragma once

#include <string>
#include <vector>

#include "export/deck_run.h"

namespace furrow {

using ForceRows = std::vector<std::vector<double>>;  // step or row, then Fx and Fy of each plate and each wall

struct OwnRun {
  ForceRows forces;
  State end;
  std::vector<Tear> tears;  // in the order of their times
};

// Watched as furrow run does it. Throws Divergence, also where furrow run would end it as invalid.
OwnRun own_run(Prepared& prepared, const std::string& method, double step, double until);

// Of the part in columns c and c + 1. The first row is passed over: the engine's plates have no speed before their first
// step. Only rows up to `last` count.
double greatest_force(const ForceRows& rows, std::size_t c, std::size_t last);

// The greatest difference over the greatest force of furrow's.
double force_error(const ForceRows& engine, const ForceRows& own, std::size_t c);

struct Mean {
  double value = 0, error = 0;  // N, its standard error
};

// Of the size of the force, over the rows after `first`.
Mean mean_force(const ForceRows& rows, std::size_t c, std::size_t first);

}  // namespace furrow
