// The commands of the program `furrow` that run scenes. Each returns its exit code.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/run_files.h"
#include "program/exit_code.h"
#include "program/progress.h"
#include "scene/keys.h"
#include "scene/scene.h"

namespace furrow {

struct RunOptions {
  std::string scene;
  // What changes the scene, as it was given: what the texts must be stands in the scene's schema.
  std::optional<std::string> method, step, until, locate, threads, solver, frames;
  std::vector<std::string> set;  // "time.step=1e-4"
  std::string resume;            // directory of a run to go on with; empty: begin
  std::string directory;         // empty: runs/ and the name of the scene
  bool json = false;             // run.json on standard output, a terminal or not
};

// The scene with the changes from the command line, judged as it will run. Throws SceneError with all that is wrong.
Scene requested_scene(const RunOptions& options);

// What `check` warns of in a scene file. Throws SceneError with all that is wrong, room for its packings included.
std::vector<std::string> checked_warnings(const std::string& scene);
int check_command(const std::vector<std::string>& scenes);

int run_command(const RunOptions& options);

// A run with all its files, as `run` makes it, shown on the progress.
RunOutcome run_one(const RunOptions& options, Progress& progress);
int exit_code_of(const RunOutcome& outcome);
int explain_command(const RunOptions& options);

struct ExportOptions {
  RunOptions scene;  // with the directory of the deck
  std::string to = "lammps";
  std::vector<std::string> allow;  // keys that may go in by another law
  std::string compare;             // directory of a deck that has run; empty: export
  double early = 0.05;             // s
};
int export_command(const ExportOptions& options);
int compare_command(const ExportOptions& options);

struct KeysOptions {
  std::vector<std::string> patterns;  // empty: all keys
  bool json = false, markdown = false, schema = false;
};
int keys_command(const KeysOptions& options);

// The keys as a JSON list, as a page, and all of them as JSON Schema, draft 2020-12.
std::string keys_as_json(const std::vector<SceneKey>& keys);
std::string keys_as_page(const std::vector<SceneKey>& keys);
std::string scene_schema();

}  // namespace furrow
