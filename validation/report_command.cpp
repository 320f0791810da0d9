// `furrow report`: the paper's three scenes and one page about them.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "output/build_info.h"
#include "output/file_list.h"
#include "output/files.h"
#include "output/run_files.h"
#include "output/strict_json.h"
#include "program/commands.h"
#include "program/progress.h"
#include "program/usage.h"
#include "scene/hash.h"
#include "scene/lattice_parts.h"
#include "scene/read.h"
#include "validation/commands.h"
#include "validation/page/report.h"
#include "validation/page/run_record.h"
#include "validation/page/studies.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string directory = "report";
  std::string scenes = "validation/scenes";
  bool reuse = false, players = false;
  std::string checks, faults, studies, mutants, judgements;  // what verification left, shown on the page; see Evidence
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
  std::ifstream file = regular_file(directory / "run.json");
  if (!file) return "there is none";
  const auto json = json_or_discarded(file);
  if (!json.is_object()) return "its run.json cannot be read";
  const BuildInfo& build = build_info();
  const std::array<std::pair<const char*, nlohmann::ordered_json>, 7> wanted{
      {{"ended", "finished"},
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
  return spoilt_file(directory);
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

constexpr double pictures_beside = 90;  // of runs beside others: with 120 all films together would be over 1.5 MB

// Times of pictures that make a film, `most` and those of the scene file among them; as a value of output.frames.
std::string film_times(const Scene& scene, double most = 120) {
  constexpr double least_apart = 0.01;  // s
  const int count = static_cast<int>(std::min(most, std::floor(scene.time.end / least_apart)));
  std::vector<double> times = scene.output.frames;
  for (int k = 0; k <= count; ++k) {
    const double t = count > 0 ? scene.time.end * k / count : 0;
    if (std::none_of(times.begin(), times.end(),
                     [&](double other) { return std::fabs(other - t) < 2 * scene.time.step; }))
      times.push_back(t);
  }
  std::sort(times.begin(), times.end());
  std::string text;
  for (const double t : times) text += (text.empty() ? "[" : ", ") + number(t);
  return text + "]";
}

// What the players put beside a scene: the name of the run's directory, what the reader is told, and what is changed.
struct Beside {
  std::string scene, name, label;
  std::vector<std::string> set;
  bool same_but_step = false;
  bool plays = true;   // else it is only drawn
  std::string file{};  // under the scenes' directory; empty: the scene's own
};

const std::vector<Beside>& runs_beside() {
  static const std::vector<std::string> spheres{"model.disc_mass=\"sphere\"", "settle.step=1e-5",
                                                "allow.energy_made=1e6", "allow.overlap=100", "allow.step=1e6"};
  static const auto finer = [](std::vector<std::string> set, const char* step = "1e-5") {
    set.emplace_back("time.step=" + std::string(step));
    return set;
  };
  static const std::vector<Beside> all = [] {
    std::vector<Beside> list;
    for (const std::string scene : {"scenario_1", "scenario_2", "scenario_3"}) {
      list.push_back({scene, scene + "_finer", "with a tenth of the step, 0.01 ms", finer({}), true});
      list.push_back({scene, scene + "_half", "", finer({}, "5e-5"), true, false});
      list.push_back({scene, scene + "_fifth", "", finer({}, "2e-5"), true, false});
    }
    for (const std::string scene : {"scenario_2", "scenario_3"}) {
      list.push_back({scene, scene + "_spheres", "spheres instead of discs, 0.1 ms", spheres});
      list.push_back({scene, scene + "_spheres_finer", "spheres, a tenth of the step, 0.01 ms", finer(spheres)});
    }
    for (const std::string scene : {"scenario_1", "scenario_2", "scenario_3"})
      list.push_back({scene,
                      scene + "_best_reading",
                      "the best valid reading of the search",
                      {},
                      false,
                      true,
                      "best_reading/" + scene + ".toml"});
    return list;
  }();
  return all;
}

constexpr const char* tool_that_bends = "deformable_tool.toml";

fs::path file_of(const ReportOptions& options, const Beside& beside) {
  return fs::path(options.scenes) / (beside.file.empty() ? beside.scene + ".toml" : beside.file);
}

// What the players show beside the three scenes. The page says which of them are not there.
std::vector<fs::path> scenes_of_players(const ReportOptions& options) {
  std::vector<fs::path> files;
  if (!options.players) return files;
  for (const Beside& beside : runs_beside())
    if (!beside.file.empty()) files.push_back(file_of(options, beside));
  files.push_back(fs::path(options.scenes) / tool_that_bends);
  return files;
}

// A run to be made, unless the one that is there will do.
void want(const ReportOptions& options, RunOptions one, std::vector<RunOptions>& wanted) {
  const Scene asked = requested_scene(one);  // says what is wrong with any of them before the first one starts
  if (!options.reuse || !reused(one, asked)) wanted.push_back(std::move(one));
}

// The tool that bends, and with all its nodes driven, for the player.
std::vector<OtherRun> tools(const ReportOptions& options, std::vector<RunOptions>& wanted) {
  const fs::path file = fs::path(options.scenes) / tool_that_bends, place = options.directory;
  if (!options.players || !fs::is_regular_file(file)) return {};
  const Scene scene = requested_scene({.scene = file});
  std::string rows;
  const Lattice& tool = scene.lattice.at(0);
  const std::size_t count =
      held_nodes(tool).size() / static_cast<std::size_t>(tool.columns);  // of a stem it is not a key
  for (std::size_t row = 0; row < count; ++row) rows += (row == 0 ? "" : ", ") + std::to_string(row);
  const std::string pictures = "output.frames=" + film_times(scene);
  want(options, {.scene = file, .set = {pictures}, .directory = place / "tool_that_bends"}, wanted);
  want(options,
       {.scene = file, .set = {"lattice[0].drive[0].rows=[" + rows + "]", pictures}, .directory = place / "rigid_tool"},
       wanted);
  return {{"a tool that bends", place / "tool_that_bends"}, {"the same tool made rigid", place / "rigid_tool"}};
}

// Outside of the source tree there are none where they are looked for.
void require_scenes(const fs::path& directory) {
  for (const char* name : {"scenario_1.toml", "scenario_2.toml", "scenario_3.toml"}) {
    if (fs::is_regular_file(directory / name)) continue;
    throw FileError("there is no scene " + (directory / name).string() + ", seen from " + fs::current_path().string() +
                    ": run in the source tree, or say with --scenes DIR where the scenes are");
  }
}

int report_command(const ReportOptions& options, const std::vector<Study>& catalogue) {
  require_scenes(options.scenes);
  std::vector<ReportedRun> runs;
  std::vector<RunOptions> wanted;
  for (const std::string name : {"scenario_3", "scenario_2", "scenario_1"}) {  // the longest first
    const fs::path file = fs::path(options.scenes) / (name + ".toml"), directory = fs::path(options.directory) / name;
    const Scene scene = requested_scene({.scene = file});
    const std::string pictures = "output.frames=" + film_times(scene);
    want(options, {.scene = file, .set = {pictures}, .directory = directory}, wanted);
    runs.push_back({name, directory, scene.output.frames});
    for (const Beside& beside : runs_beside()) {
      if (!options.players || beside.scene != name) continue;
      const fs::path place = fs::path(options.directory) / beside.name, its = file_of(options, beside);
      if (!fs::is_regular_file(its)) continue;
      RunOptions one{.scene = its, .set = beside.set, .directory = place};
      if (beside.plays)
        one.set.push_back("output.frames=" + film_times(requested_scene({.scene = its}), pictures_beside));
      want(options, std::move(one), wanted);
      runs.back().others.push_back({beside.label, place, beside.same_but_step, beside.plays});
    }
  }
  const std::vector<OtherRun> tool = tools(options, wanted);
  OwnedDirectory directory(options.directory, "report", page_files());
  const int worst = run_side_by_side(wanted);
  if (worst == interrupted) return interrupted;
  std::reverse(runs.begin(), runs.end());
  const Evidence evidence{options.checks, options.faults,  options.studies,    catalogue,
                          now_in_utc(),   options.mutants, options.judgements, scenes_of_players(options)};
  Progress progress;
  progress.begin("report", "drawing");
  write_report(directory, runs, evidence, tool);
  progress.end();
  directory.conclude("finished");
  std::cout << (fs::path(options.directory) / "index.html").string() << "\n";
  if (const std::string ages = ages_in_words(evidence); !ages.empty()) std::cerr << ages << "\n";
  const std::vector<std::string> missing = missing_evidence(evidence);
  for (const std::string& why : missing) std::cerr << "furrow: missing on the page: " << why << "\n";
  return worst == good && (failed_checks(evidence) > 0 || !missing.empty()) ? check_failed : worst;
}

}  // namespace

void add_report_command(CLI::App& app, std::vector<Command>& all, const std::vector<Study>& catalogue) {
  static ReportOptions reported;
  auto* report = app.add_subcommand("report", "run the paper's three scenes and write one page about them");
  show_examples(report, {"furrow report --out report", "furrow report --reuse --studies reference_data/studies"});
  report->add_option("--out", reported.directory, "directory for the page and the runs")
      ->capture_default_str()
      ->type_name("DIR");
  report->add_option("--scenes", reported.scenes, "directory of the scene files")
      ->capture_default_str()
      ->type_name("DIR");
  report->add_flag("--reuse", reported.reuse, "keep runs that are there and finished, make only the page again");
  report->add_flag(
      "--players", reported.players,
      "run scenes again with a tenth of the step and with spheres, to be put beside the others in the players");
  report->add_option("--checks", reported.checks, "checks.json of the verification tests, to be shown on the page")
      ->type_name("FILE");
  report->add_option("--faults", reported.faults, "faults.json of the fault study, to be shown on the page")
      ->type_name("FILE");
  report->add_option("--studies", reported.studies, "directory of the studies' results, to be shown on the page")
      ->type_name("DIR");
  report->add_option("--mutants", reported.mutants, "mutants.json of scripts/mutants, to be shown on the page")
      ->type_name("FILE");
  report->add_option("--judgements", reported.judgements, "judgements.json of scripts/judge, to be shown on the page")
      ->type_name("FILE");
  all.push_back({report, [&catalogue] { return report_command(reported, catalogue); }});
}
}  // namespace furrow::validation
