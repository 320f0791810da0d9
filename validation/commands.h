// The commands of validation on the command line.
#pragma once

#include <vector>

#include "program/program.h"

namespace furrow::validation {

// report
void add_report_command(CLI::App& app, std::vector<Command>& all);

}  // namespace furrow::validation
