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
  std::optional<std::string> method;
  std::optional<double> step;   // s
  std::optional<double> until;  // s
  std::optional<Locate> locate;
  std::optional<int> threads;
  std::string directory;  // empty: runs/<name of the scene>
};

// The scene with the changes from the command line. Throws SceneError for a bad file, std::invalid_argument for a bad
// change.
Scene requested_scene(const RunOptions& options);

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
