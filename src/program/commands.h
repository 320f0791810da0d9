// The commands of the program `furrow`. Each returns its exit code.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace furrow {

enum ExitCode { good = 0, check_failed = 1, bad_input = 2, diverged = 3, io_failed = 4, interrupted = 130 };

struct RunOptions {
  std::string scene;
  std::optional<std::string> method;
  std::optional<double> step;   // s
  std::optional<double> until;  // s
  std::string directory;        // empty: runs/<name of the scene>
};

int run_command(const RunOptions& options);
int check_command(const std::vector<std::string>& scenes);
int explain_command(const RunOptions& options);
int methods_command();
int report_command(const std::string& directory, const std::string& scenes, bool reuse);

}  // namespace furrow
