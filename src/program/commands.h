// The commands of the program `furrow` that run scenes. Each returns its exit code.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace furrow {

enum ExitCode { good = 0, check_failed = 1, bad_input = 2, diverged = 3, io_failed = 4, interrupted = 130 };

struct RunOptions {
  std::string scene;
  // What changes the scene, as it was given: what the texts must be stands in the scene's schema.
  std::optional<std::string> method, step, until, locate, threads, solver;
  std::string resume;     // directory of a run to go on with; empty: begin
  std::string directory;  // empty: runs/<name of the scene>
};

// The scene with the changes from the command line, judged as it will run. Throws SceneError with all that is wrong.
Scene requested_scene(const RunOptions& options);

// What `check` warns of in a scene file. Throws SceneError with all that is wrong, room for its packings included.
std::vector<std::string> checked_warnings(const std::string& scene);
int check_command(const std::vector<std::string>& scenes);

int run_command(const RunOptions& options);
int explain_command(const RunOptions& options);

struct StabilityOptions {
  std::string scene;
  std::vector<std::string> methods;  // none: all that step by themselves
  double at = 0;                     // s
};
int stability_command(const StabilityOptions& options);

struct ReportOptions {
  std::string directory = "report";
  std::string scenes = "validation/scenes";
  bool reuse = false;
  std::string checks, faults, studies;  // what verification left, shown on the page; see Evidence
};
int report_command(const ReportOptions& options);

struct StudyOptions {
  std::string name;  // empty: list the studies
  std::string directory = "studies";
  bool quick = false;
  unsigned jobs = 0;  // 0: as many as there are processors
  bool few = false;   // of the ensemble: a few packings, compared with the kept result in `directory`
};
int study_command(const StudyOptions& options);

struct GoldenRequest {
  std::string directory = "reference_data/golden", reason;
  bool quick = false, remake = false;
};
int golden_command(const GoldenRequest& request);

}  // namespace furrow
