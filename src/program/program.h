// The program: a list of commands, put together where it is linked. The solver's own are here; those of verification,
// validation and benchmarks stand with them.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "program/exit_code.h"

namespace furrow {

struct Command {
  const CLI::App* named;     // chosen if the command line has parsed it
  std::function<int()> run;  // returns its exit code
};

// Adds commands to the command line and to the list.
using AddCommands = void (*)(CLI::App& app, std::vector<Command>& all);

// run, check, explain, methods.
void add_solver_commands(CLI::App& app, std::vector<Command>& all);

// All of main(): reads the command line, runs what it asks for, says what went wrong in one line. Returns the exit
// code.
int run_program(int argc, char** argv, const std::vector<AddCommands>& parts);

}  // namespace furrow
