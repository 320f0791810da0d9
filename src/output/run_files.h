// A run with its files: prepares a scene, runs it, writes what is seen, and says how it ended.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "scene/scene.h"
#include "system/run.h"

namespace furrow {

struct RunRequest {
  std::string scene_file;  // as the user named it
  Scene scene;             // with the user's changes applied
  std::filesystem::path directory;
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

// Writes plate_force.csv, energy.csv, motion.csv, events.csv, state.csv, scene.toml, frames/, run.pvd and run.json. Of
// an interrupted run the series keep the ending .partial, a diverged one is complete up to its last good state;
// run.json says which. An earlier run in the directory is replaced; any other content is an error. Throws FileError.
RunOutcome run_with_files(const RunRequest& request);

}  // namespace furrow
