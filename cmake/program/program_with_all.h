// What is added to the program of the solver where verification, validation and benchmarks are there too.
#pragma once

#include <vector>

#include "program/program.h"

namespace furrow {

// study, ensemble, statements, golden.
void add_study_commands(CLI::App& app, std::vector<Command>& all);

}  // namespace furrow
