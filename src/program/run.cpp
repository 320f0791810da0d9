#include <unistd.h>

#include <array>
#include <atomic>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "output/build_info.h"
#include "output/files.h"
#include "output/run_files.h"
#include "output/strict_json.h"
#include "program/commands.h"
#include "program/progress.h"
#include "program/run_summary.h"
#include "scene/missing_path.h"
#include "scene/read.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

fs::path directory_of(const RunOptions& options) {
  fs::path wanted = !options.resume.empty() ? options.resume : options.directory;
  if (!wanted.empty()) return wanted;
  const fs::path name = fs::path(options.scene).stem();
  if (name == "." || name == "..")
    throw std::invalid_argument(options.scene + ": its name gives no directory for the files; say --out DIR");
  return "runs" / name;
}

// Which finished run of another scene file the directory holds; empty: none, or it does not say.
std::string other_run_in(const fs::path& directory, const fs::path& scene) {
  std::ifstream stream = regular_file(directory / "run.json");
  const auto run = stream ? json_or_discarded(stream) : nlohmann::ordered_json();
  if (!run.is_object() || run.value("ended", nlohmann::ordered_json()) != "finished") return {};
  const auto of = run.value("scene", nlohmann::ordered_json());
  std::error_code unknown;
  const bool other =
      of.is_string() && fs::weakly_canonical(of.get<std::string>(), unknown) != fs::weakly_canonical(scene, unknown);
  return other ? of.get<std::string>() : "";
}

}  // namespace

int exit_code_of(const RunOutcome& outcome) {
  return outcome.ended == "finished" ? good : outcome.ended == "interrupted" ? interrupted : diverged;
}

RunOutcome run_one(const RunOptions& options, Progress& progress) {
  const std::string name = fs::path(options.scene).stem();
  const bool resumes = !options.resume.empty();
  const fs::path wanted = resumes ? options.resume : options.directory, directory = directory_of(options);
  if (std::error_code unreachable; resumes && !fs::is_directory(directory, unreachable))
    throw FileError(directory.string() + ": no such directory, so no run to go on with" +
                    instead_of(directory, PathKind::directory));
  RunRequest request{
      .scene_file = options.scene, .scene = requested_scene(options), .directory = directory, .resume = resumes};
  request.progress = [&](const std::string& doing, double done, double total) {
    return progress.show(name, doing, done, total);
  };
  request.warn = [&](const std::string& text) { progress.say(name + ": warning: " + text); };
  if (const std::string other = resumes ? "" : other_run_in(directory, options.scene); !other.empty())
    progress.say("furrow: " + name + ": the finished run of " + other + " in " + directory.string() + " is replaced");
  progress.begin(name, "preparing");
  RunOutcome outcome = run_with_files(request);
  const std::string in_directory = " in " + directory.string();
  if (outcome.ended == "finished" && wanted.empty())
    progress.say("furrow: " + name + " finished; its files are" + in_directory + " (--out DIR puts them elsewhere)");
  if (outcome.ended == "diverged")
    progress.say("furrow: error: " + name + " diverged: " + outcome.reason +
                 (fs::exists(directory / "state.csv") ? "; the last good state is" : "; what it had written is") +
                 in_directory);
  if (outcome.ended == "invalid")
    progress.say("furrow: error: " + name + " is invalid: " + outcome.reason + "; what it had written is" +
                 in_directory);
  if (outcome.ended == "interrupted")
    progress.say("furrow: " + name + " was " + outcome.reason + in_directory +
                 ": the series that it had begun end there and keep the ending .partial" +
                 (has_checkpoint(directory) ? "; --resume " + directory.string() + " goes on with it" : ""));
  return outcome;
}

int run_command(const RunOptions& options) {
  const fs::path directory = directory_of(options);
  std::error_code unreachable;  // said when the directory is made
  const bool replaces = options.resume.empty() && fs::exists(directory / "run.json", unreachable);
  Progress progress;
  const RunOutcome outcome = run_one(options, progress);
  progress.end();
  if (isatty(STDOUT_FILENO) != 0 && !options.json) {
    std::cout << run_summary(outcome.json, directory, replaces) << std::flush;
  } else {
    std::cout << outcome.json << std::flush;
  }
  return exit_code_of(outcome);
}

}  // namespace furrow
