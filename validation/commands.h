// The commands of validation on the command line.
#pragma once

#include <vector>

#include "program/program.h"
#include "report/study.h"

namespace furrow::validation {

// report; the chapters of `catalogue` make the words about studies.
void add_report_command(CLI::App& app, std::vector<Command>& all, const std::vector<Study>& catalogue);

// calibrate.
void add_calibrate_command(CLI::App& app, std::vector<Command>& all);

// view
void add_view_command(CLI::App& app, std::vector<Command>& all);

}  // namespace furrow::validation
