// A run with its files: prepares a scene, runs it, writes what is seen, and says how it ended.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "run/run.h"
#include "scene/scene.h"

namespace furrow {

struct RunRequest {
  std::string scene_file;  // as the user named it
  Scene scene;             // with the user's changes applied
  std::filesystem::path directory;
  bool resume = false;  // go on with the run that is there
  // Called now and then: what is being done, done and total model time. False interrupts.
  std::function<bool(const std::string& doing, double done, double total)> progress = [](const std::string&, double,
                                                                                         double) { return true; };
  std::function<void(const std::string&)> warn = [](const std::string&) {};
};

struct RunOutcome {
  std::string ended;   // "finished", "diverged", "invalid" or "interrupted"
  std::string reason;  // of a divergence or invalidity
  std::string json;    // what run.json says
};

// Writes plate_force.csv, wall_force.csv, energy.csv, motion.csv, events.csv, state.csv, scene.toml, frames/, run.pvd and run.json into
// a directory of its own, see owned_directory.h: a run that is there is replaced, however it ended. What grows with an
// interrupted run ends where it was stopped and keeps the ending .partial: the series, run.pvd and frames/frames.csv.
// What is whole in itself has its name: each picture, state.csv as it was then, scene.toml, and run.json, which says
// how the run ended. A diverged run is complete up to its last good state. Throws FileError.
//
// The file `checkpoint` is written at the start, every output.checkpoint, when a run is interrupted, and before the
// first step that has the end in sight; a run that diverges keeps its last one. From there a run goes on: the same bits
// in the same files as if it had never ended. Throws std::invalid_argument if it is the run of another scene or
// program.
RunOutcome run_with_files(const RunRequest& request);

// Whether there is anything to resume from.
bool has_checkpoint(const std::filesystem::path& directory);

}  // namespace furrow
