#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "methods/method.h"
#include "output/files.h"
#include "output/run_files.h"
#include "page/report.h"
#include "program/commands.h"
#include "program/progress.h"
#include "program/request.h"
#include "scene/read.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

int exit_code_of(const RunOutcome& outcome) {
  return outcome.ended == "finished" ? good : outcome.ended == "diverged" ? diverged : interrupted;
}

RunOutcome run_one(const RunOptions& options, const fs::path& directory, Progress& progress) {
  const std::string name = fs::path(options.scene).stem();
  RunRequest request{options.scene, requested_scene(options), directory, {}, {}};
  request.progress = [&](const std::string& doing, double done, double total) {
    progress.show(name, doing, done, total);
    return !was_interrupted();
  };
  request.warn = [&](const std::string& text) { progress.say(name + ": warning: " + text); };
  RunOutcome outcome = run_with_files(request);
  if (outcome.ended == "diverged") {
    progress.say("furrow: error: " + name + " diverged: " + outcome.reason + "; the last good state is in " +
                 directory.string());
  } else if (outcome.ended == "interrupted") {
    progress.say("furrow: " + name + " was interrupted; what it had written is marked .partial in " +
                 directory.string());
  }
  return outcome;
}

bool finished_run_in(const fs::path& directory) {
  std::ifstream file(directory / "run.json");
  const auto json = nlohmann::json::parse(file, nullptr, false);
  return json.is_object() && json.value("ended", "") == "finished";
}

}  // namespace

Scene requested_scene(const RunOptions& options) {
  Scene scene = read_scene(options.scene);
  if (options.method) scene.time.method = *options.method;
  if (options.step) scene.time.step = *options.step;
  if (options.until) {
    scene.time.end = *options.until;
    std::erase_if(scene.output.frames, [&](double t) { return t > scene.time.end; });
  }
  make_method(scene.time.method);  // throws if there is none of that name
  if (scene.time.step > scene.time.end) throw std::invalid_argument("the step is longer than the run");
  return scene;
}

int run_command(const RunOptions& options) {
  catch_interrupts();
  const fs::path directory =
      options.directory.empty() ? fs::path("runs") / fs::path(options.scene).stem() : fs::path(options.directory);
  Progress progress;
  const RunOutcome outcome = run_one(options, directory, progress);
  std::cout << outcome.json << std::flush;
  return exit_code_of(outcome);
}

int report_command(const std::string& directory, const std::string& scenes, bool reuse) {
  catch_interrupts();
  std::vector<ReportedRun> runs;
  std::vector<RunOptions> wanted;
  for (const char* name : {"scenario_3", "scenario_2", "scenario_1"}) {  // the longest first
    runs.push_back({name, fs::path(directory) / name});
    RunOptions options;
    options.scene = (fs::path(scenes) / (std::string(name) + ".toml")).string();
    if (!reuse || !finished_run_in(runs.back().directory)) wanted.push_back(options);
    requested_scene(options);  // say what is wrong with any of them before the first one starts
  }
  int worst = good;
  {
    Progress progress;
    std::mutex mutex;
    std::size_t next = 0;
    std::exception_ptr failure;
    const auto work = [&] {
      while (true) {
        RunOptions mine;
        {
          const std::scoped_lock lock(mutex);
          if (next == wanted.size() || failure) return;
          mine = wanted[next++];
        }
        try {
          const int code = exit_code_of(run_one(mine, fs::path(directory) / fs::path(mine.scene).stem(), progress));
          const std::scoped_lock lock(mutex);
          worst = std::max(worst, code);
        } catch (...) {
          const std::scoped_lock lock(mutex);
          failure = std::current_exception();
        }
      }
    };
    std::vector<std::thread> threads;
    for (unsigned k = 0; k < std::max(1U, std::thread::hardware_concurrency()); ++k) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
  }
  if (worst == interrupted) return interrupted;
  std::reverse(runs.begin(), runs.end());
  write_report(directory, runs);
  std::cout << (fs::path(directory) / "index.html").string() << "\n";
  return worst;
}

}  // namespace furrow
