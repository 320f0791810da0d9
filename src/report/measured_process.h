// Runs a program and says what it took.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace furrow {

struct MeasuredEnd {
  int status = 0;          // exit code, or 128 + signal
  double cpu_seconds = 0;  // user and system, its children included
  double real_seconds = 0;
  std::string output;  // standard output
};

struct MeasuredCommand {
  std::vector<std::string> words;             // program, then arguments
  std::filesystem::path directory{};          // to run in; empty: this one
  std::vector<std::string> environment{};     // NAME=VALUE, added to this process's
  std::filesystem::path errors{"/dev/null"};  // standard error goes there
};

// Throws std::runtime_error if the program cannot be started.
MeasuredEnd run_measured(const MeasuredCommand& command);

// The same, but a status other than 0 throws with the command and where its errors are.
MeasuredEnd run_measured_well(const MeasuredCommand& command);

}  // namespace furrow
