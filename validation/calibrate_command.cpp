// `furrow calibrate`: the settings of scenes that come closest to what was measured.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>
#include <thread>

#include "program/exit_code.h"
#include "program/progress.h"
#include "program/usage.h"
#include "scene/wording.h"
#include "validation/calibration/calibration.h"
#include "validation/commands.h"

namespace furrow::validation {
namespace {

struct Options {
  std::vector<std::string> scenes, vary;
  std::string targets, directory = "calibration";
  int points = 100, packings = 1;
  std::optional<int> fresh{};
  unsigned jobs = 0;
};

// About the best setting.
void print_without_effect(const Calibration& c) {
  for (const VariedKey& key : c.keys) {
    const auto moves = [&](const Effect& effect) {
      return effect.key == key.name && (effect.misfit != 0 || std::any_of(effect.effect.begin(), effect.effect.end(),
                                                                          [](double off) { return off != 0; }));
    };
    const std::vector<Effect>& all = c.identified.effects;
    if (std::none_of(all.begin(), all.end(), moves))
      std::printf("  %s moves no target about the best setting: its value says nothing\n", key.name.c_str());
  }
}

void print_unsaid(const Calibration& c) {
  const std::vector<Json>& packings = c.best.front().fresh.values;
  for (std::size_t k = 0; k < c.targets.all.size(); ++k) {
    const CalibrationTarget& target = c.targets.all[k];
    const auto unsaid = std::count_if(packings.begin(), packings.end(),
                                      [&](const Json& values) { return !comparable(target, values[k]); });
    if (unsaid > 0)
      std::printf("  %s: %td of %td runs with the best setting do not say it\n", target.name.c_str(), unsaid,
                  std::ssize(packings));
  }
}

void print(const Calibration& c, const std::string& directory) {
  const Candidate& best = c.best.front();
  std::printf("misfit %s of tolerances: %s\n", rounded(best.fresh.misfit(), 3).c_str(),
              text_of(c.keys, best.searched.setting).c_str());
  for (const Known& known : c.identified.known) std::printf("  %s\n", words_of(known).c_str());
  print_without_effect(c);
  print_unsaid(c);
  if (!c.identified.why_not.empty()) std::printf("  no intervals: %s\n", c.identified.why_not.c_str());
  std::printf("%ld settings, %ld of them failed; %ld runs made, %ld replayed\n", c.points, c.failed, c.made,
              c.replayed);
  std::printf("%s/calibration.html, calibration.json; run the best: furrow run %s/best/%s.toml\n", directory.c_str(),
              directory.c_str(), c.cases.front().name.c_str());
}

int search(const Options& options) {
  Progress progress;
  CalibrationRequest request{.scenes = {options.scenes.begin(), options.scenes.end()},
                             .vary = options.vary,
                             .targets = options.targets,
                             .directory = options.directory};
  request.plan.global_points = options.points - options.points * 2 / 5;
  request.plan.local_points = options.points * 2 / 5;
  request.plan.packings = options.packings;
  request.plan.jobs = options.jobs > 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  request.fresh = options.fresh;
  request.progress = [&](double made, double all) { return progress.show("calibrate", "running", made, all); };
  progress.begin("calibrate", "preparing");
  const Calibration calibration = calibrate(request);
  progress.end();
  write_calibration(calibration, options.directory);
  print(calibration, options.directory);
  return good;
}

int command(const Options& options) {
  try {
    return search(options);
  } catch (const NothingCompared& fault) {
    std::cerr << "furrow: error: " << fault.what() << "\n";
    return check_failed;
  }
}

}  // namespace

void add_calibrate_command(CLI::App& app, std::vector<Command>& all) {
  static Options options;
  auto* named = app.add_subcommand("calibrate", "find the settings of scenes that come closest to what was measured");
  show_examples(named, {"furrow calibrate src/python/stem.toml --vary 'lattice[0].structural.stiffness=5e3:3e4:log' "
                        "--to validation/calibration/example/bent_stem.toml --points 20 --out fitted"});
  named->add_option("scenes", options.scenes, "scene files, calibrated together")->required()->type_name("");
  named
      ->add_option(
          "--vary", options.vary,
          "what varies, as KEY=low:high, KEY=low:high:log or KEY=a,b,c; of a key that is an integer a range is "
          "its integers; keys with commas between them share a value, SCENE:KEY is of one scene")
      ->required()
      ->type_name("KEY=VALUES")
      ->expected(1)
      ->take_all();
  named->add_option("--to", options.targets, "file of targets, TOML or JSON")->required()->type_name("FILE");
  named->add_option("--points", options.points, "settings tried for each combination of listed values")
      ->capture_default_str()
      ->check(whole_number(5, 1000000))
      ->type_name("NUMBER");
  named->add_option("--packings", options.packings, "packings of the beds for each setting")
      ->capture_default_str()
      ->check(whole_number(1, 1000))
      ->type_name("NUMBER");
  named->add_option("--fresh", options.fresh, "further packings for the best few, for the spread of the misfit")
      ->default_str(std::to_string(usual_fresh))
      ->check(whole_number(2, 1000))
      ->type_name("NUMBER");
  named->add_option("--jobs", options.jobs, "runs at a time (default: one a processor)")
      ->check(whole_number(1, 1024))
      ->type_name("NUMBER");
  named->add_option("--out", options.directory, "directory for the results; runs that it has are not made again")
      ->capture_default_str()
      ->type_name("DIR");
  all.push_back({named, [] { return command(options); }});
}

}  // namespace furrow::validation
