// The page of results: the runs of the paper's three scenes beside what the paper reports of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/owned_directory.h"
#include "validation/page/verification.h"

namespace furrow::validation {

// A run to be put beside another in its player.
struct OtherRun {
  std::string label;
  std::filesystem::path directory;
  bool same_but_step = false;  // the same scene by another step
  bool plays = true;           // in the player
};

struct ReportedRun {
  std::string name;                 // "scenario_1" ...: the scene as validation/statements.toml calls it
  std::filesystem::path directory;  // where the run's files are
  std::vector<double> stills{};     // s: pictures that stand on the page, as the paper has them; none: all are such
  std::vector<OtherRun> others{};
};

constexpr std::size_t least_film = 20;  // pictures: with fewer a run has no player

// What every report writes, to take its directory for.
std::vector<std::string> page_files();

// Writes index.html, which needs no other file, scenes.md, and the figures beside them as SVG. Runs that diverged or
// were interrupted are shown as such. Throws std::runtime_error: gnuplot missing, a file missing or malformed; then
// nothing is written.
// `tools`: runs of one scene with a driven lattice, for a player of their own.
void write_report(OwnedDirectory& directory, const std::vector<ReportedRun>& runs, const Evidence& evidence = {},
                  const std::vector<OtherRun>& tools = {});

}  // namespace furrow::validation
