// `furrow report`: the paper's three scenes and one page about them.
#include <array>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "output/build_info.h"
#include "output/files.h"
#include "output/run_files.h"
#include "program/commands.h"
#include "program/progress.h"
#include "scene/hash.h"
#include "scene/read.h"
#include "validation/commands.h"
#include "validation/page/report.h"
#include "validation/page/run_record.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string directory = "report";
  std::string scenes = "validation/scenes";
  bool reuse = false;
  std::string checks, faults, studies;  // what verification left, shown on the page; see Evidence
};

// As many at once as the machine has processors. Returns the worst exit code.
int run_side_by_side(const std::vector<RunOptions>& wanted) {
  Progress progress;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    int worst = good;
    try {
      for (std::size_t k; (k = next++) < wanted.size();)
        worst = std::max(worst, exit_code_of(run_one(wanted[k], progress)));
    } catch (...) {
      next = wanted.size();  // nothing more is begun
      throw;
    }
    return worst;
  };
  std::vector<std::future<int>> workers(std::max(1U, std::thread::hardware_concurrency()));
  for (auto& worker : workers) worker = std::async(std::launch::async, work);
  int worst = good;
  for (auto& worker : workers) worst = std::max(worst, worker.get());
  return worst;
}

// Why a run that is there does not stand for a run of that scene by this program; empty if it does.
std::string other_run(const fs::path& directory, const Scene& scene) {
  std::ifstream file(directory / "run.json");
  if (!file) return "there is none";
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object()) return "its run.json cannot be read";
  const BuildInfo& build = build_info();
  const std::array<std::pair<const char*, nlohmann::json>, 7> wanted{{{"ended", "finished"},
                                                                      {"scene_hash", hexadecimal(scene_hash(scene))},
                                                                      {"method", scene.time.method},
                                                                      {"step", scene.time.step},
                                                                      {"sources", build.sources},
                                                                      {"compiler", build.compiler},
                                                                      {"flags", build.flags}}};
  for (const auto& [key, value] : wanted) {
    const auto found = json.find(key);
    if (found == json.end()) return std::string("its run.json does not say its ") + key;
    if (*found != value) return std::string(key) + " is " + found->dump() + ", not " + value.dump();
  }
  const RunRecord record = read_run(directory.filename(), directory);
  if (scene_hash(record.scene) != scene_hash(scene)) return "its scene.toml is of another scene";
  return broken_off(record);
}

// Whether the run in its directory is taken as it is; if not, the reason is said.
bool reused(const RunOptions& options, const Scene& scene) {
  std::string why;
  try {
    why = other_run(options.directory, scene);
  } catch (const std::runtime_error& unreadable) {
    why = unreadable.what();
  }
  if (!why.empty()) std::cerr << options.directory << ": run again: " << why << "\n";
  return why.empty();
}

int report_command(const ReportOptions& options, const std::vector<Study>& catalogue) {
  std::vector<ReportedRun> runs;
  std::vector<RunOptions> wanted;
  for (const std::string name : {"scenario_3", "scenario_2", "scenario_1"}) {  // the longest first
    runs.push_back({name, fs::path(options.directory) / name});
    const RunOptions one{.scene = fs::path(options.scenes) / (name + ".toml"), .directory = runs.back().directory};
    const Scene scene = requested_scene(one);  // says what is wrong with any of them before the first one starts
    if (!options.reuse || !reused(one, scene)) wanted.push_back(one);
  }
  OwnedDirectory directory(options.directory, "report", page_files());
  const int worst = run_side_by_side(wanted);
  if (worst == interrupted) return interrupted;
  std::reverse(runs.begin(), runs.end());
  const Evidence evidence{options.checks, options.faults, options.studies, catalogue};
  write_report(directory, runs, evidence);
  directory.conclude("finished");
  std::cout << (fs::path(options.directory) / "index.html").string() << "\n";
  const std::vector<std::string> missing = missing_evidence(evidence);
  for (const std::string& why : missing) std::cerr << "furrow: missing on the page: " << why << "\n";
  return worst == good && (failed_checks(evidence) > 0 || !missing.empty()) ? check_failed : worst;
}

}  // namespace

void add_report_command(CLI::App& app, std::vector<Command>& all, const std::vector<Study>& catalogue) {
  static ReportOptions reported;
  auto* report = app.add_subcommand("report", "run the paper's three scenes and write one page about them");
  report->add_option("--out", reported.directory, "directory for the page and the runs")
      ->capture_default_str()
      ->type_name("DIR");
  report->add_option("--scenes", reported.scenes, "directory of the scene files")
      ->capture_default_str()
      ->type_name("DIR");
  report->add_flag("--reuse", reported.reuse, "keep runs that are there and finished, make only the page again");
  report->add_option("--checks", reported.checks, "checks.json of the verification tests, to be shown on the page")
      ->type_name("FILE");
  report->add_option("--faults", reported.faults, "faults.json of the fault study, to be shown on the page")
      ->type_name("FILE");
  report->add_option("--studies", reported.studies, "directory of the studies' results, to be shown on the page")
      ->type_name("DIR");
  all.push_back({report, [&catalogue] { return report_command(reported, catalogue); }});
}
}  // namespace furrow::validation
