// The page of results: the runs of the paper's three scenes beside what the paper reports of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "page/verification.h"

namespace furrow {

struct ReportedRun {
  std::string name;                 // "scenario_1" ...: the scene as validation/statements.toml calls it
  std::filesystem::path directory;  // where the run's files are
};

// Writes index.html, which needs no other file, and the figures beside it as SVG into `out`, which is made if need be.
// Runs that diverged or were interrupted are shown as such. Throws std::runtime_error: gnuplot missing, a file missing
// or malformed.
void write_report(const std::filesystem::path& out, const std::vector<ReportedRun>& runs,
                  const Evidence& evidence = {});

}  // namespace furrow
