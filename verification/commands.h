// The commands of verification on the command line.
#pragma once

#include <vector>

#include "program/program.h"

namespace furrow::verification {

// stability
void add_stability_command(CLI::App& app, std::vector<Command>& all);

// cases, judge, engine
void add_judge_commands(CLI::App& app, std::vector<Command>& all);

}  // namespace furrow::verification
