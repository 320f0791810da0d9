#include "validation/studies/golden.h"

#include <array>
#include <cmath>
#include <fstream>

#include "output/build_info.h"
#include "output/files.h"
#include "output/kept_result.h"
#include "output/schedule.h"
#include "output/strict_json.h"
#include "report/seal.h"
#include "report/study.h"
#include "run/observe.h"
#include "run/run.h"
#include "scene/hash.h"
#include "scene/read.h"
#include "validation/studies/beds.h"
#include "validation/studies/golden_compare.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

struct Which {
  std::string scene;
  Reading reading;
  std::string name() const { return scene + "_" + to_string(reading); }
};

std::vector<Which> all_runs(bool quick) {
  std::vector<Which> all{{"deformable_tool", Reading::disc},
                         {"scenario_3", Reading::disc},
                         {"scenario_2", Reading::disc},
                         {"scenario_1", Reading::disc},
                         {"best_reading/scenario_1", Reading::disc}};
  if (!quick)
    all.insert(all.begin(), {{"scenario_3", Reading::sphere},
                             {"scenario_2", Reading::sphere},
                             {"best_reading/scenario_3", Reading::disc},
                             {"best_reading/scenario_2", Reading::disc}});
  return all;
}

Json energies_of(const Energies& e) {
  return {{"kinetic", e.kinetic},         {"gravity", e.gravity},           {"springs", e.springs},
          {"contact", e.contact_elastic}, {"link_damping", e.link_damping}, {"contact_viscous", e.contact_viscous},
          {"friction", e.friction},       {"rolling", e.rolling},           {"tear", e.tear},
          {"plate_work", e.plate_work},   {"stiffening", e.stiffening}};
}

// A run as it is kept: force on the tool (its plate or its driven nodes), tears, state hashes and energies at checkpoints, positions at the end.
class Recorder {
 public:
  Recorder(const System& system, Due due) : system_(system), due_(due) {}

  void see(double t, const State& y, const JumpReport& jump) {
    for (const Tear& tear : jump.torn)
      golden_["tears"].push_back({tear.time, system_.parts().link_name(tear.link), tear.force});
    if (!due_.at(t)) return;
    const Observation seen = observe(system_, t, y);
    const Force force = seen.plate.empty() ? seen.drive.at(0) : seen.plate[0];
    golden_["force"].push_back({t, force.x, force.y});
    if (due_.taken() == 0 || std::fabs(t - first_checkpoint) < 1e-9) add_checkpoint(t, y);
    due_.take(t);
  }

  Json finished(const RunEnd& end, const State& y) {
    if (golden_["checkpoints"].empty() || golden_["checkpoints"].back().at("t") != end.time)
      add_checkpoint(end.time, y);
    golden_["ended"] = end.ending == Ending::diverged ? "diverged: " + end.reason : "finished";
    for (int body = 0; body < system_.parts().bodies(); ++body)
      golden_["positions"].push_back({y[system_.x_of(body)], y[system_.y_of(body)]});
    return golden_;
  }

 private:
  void add_checkpoint(double t, const State& y) {
    golden_["checkpoints"].push_back({{"t", t},
                                      {"hash", hexadecimal(system_.state_hash(y))},
                                      {"energies", energies_of(observe(system_, t, y).energy)}});
  }

  const System& system_;
  Json golden_{{"checkpoints", Json::array()}, {"force", Json::array()}, {"tears", Json::array()}};
  Due due_;
};

Extent extent_of(const Which& which, bool quick) {
  return quick && !which.scene.ends_with("scenario_1") ? Extent::to_first_checkpoint : Extent::whole;
}

Json run_of(const Which& which, Extent extent) {
  Scene scene = paper_scene(which.scene, which.reading, 1);
  scene.output.energy = true;
  Scene compared = scene;  // what a scene allows itself moves no bit
  compared.allow.reset();
  Json golden{{"golden", golden_format},
              {"scene", which.scene},
              {"reading", to_string(which.reading)},
              {"end", scene.time.end},
              {"scene_text", canonical_text(compared)}};
  Prepared prepared = prepare(scene);
  System& system = prepared.system;
  const auto method = make_method(scene.time.method);
  Recorder recorder(system, {method->info(), scene.time.step, golden_row_every});
  const RunPlan plan{.start = 0, .end = scene.time.end, .step = scene.time.step, .stop = {}};
  // Stopped there, not ended there: the last step of a run is cut to its end and has other bits than a whole one.
  const RunEnd ended = run(system, *method, prepared.y, plan, [&](double t, const State& y, const JumpReport& jump) {
    recorder.see(t, y, jump);
    return extent == Extent::whole || t < first_checkpoint - 1e-9;
  });
  golden.update(recorder.finished(ended, prepared.y));
  return golden;
}

Json golden_in(const fs::path& file) {
  std::ifstream stream = regular_file(file);
  return stream ? json_or_discarded(stream) : Json();
}

fs::path file_of(const Which& which, const GoldenOptions& options) {
  return options.directory / (which.name() + ".json");
}

void write_golden(const fs::path& file, Json golden, const Json& old, const std::string& reason) {
  const BuildInfo& build = build_info();
  golden["commit"] = build.commit;
  golden["compiler"] = build.compiler;
  golden["flags"] = build.flags;
  golden["reasons"] = old.is_object() && old.contains("reasons") ? old["reasons"] : Json::array();
  golden["reasons"].push_back(reason);
  seal(golden);
  replace_file(file, golden.dump() + "\n");
}

bool is_golden(const std::string& text) {
  const Json json = json_or_discarded(text);
  return json.is_object() && json.contains("checkpoints") && json.contains("reasons");
}

}  // namespace

int check_goldens(const GoldenOptions& options) {
  if (options.remake && options.reason.empty()) throw std::invalid_argument("golden --remake needs a --reason");
  if (options.remake && options.quick) throw std::invalid_argument("golden --remake needs whole runs, not --quick");
  if (!options.remake && !fs::is_directory(options.directory))
    throw FileError("no directory " + options.directory.string() + "; run in the source tree or give --goldens");
  const std::vector<Which> runs = all_runs(options.quick);
  std::vector<Task> tasks;
  for (const Which& which : runs) {
    if (options.remake) refuse_what_is_not("a golden output", file_of(which, options), is_golden);
    tasks.push_back(
        {which.name(), [which, extent = extent_of(which, options.quick)] { return run_of(which, extent); }});
  }
  const std::vector<Json> results =
      Measurement("golden", {.quick = options.quick, .jobs = options.jobs, .progress = options.progress}, {})
          .run(tasks);
  int different = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const fs::path file = file_of(runs[k], options);
    const Json old = golden_in(file);
    const Comparison found = compare_golden(results[k], old, extent_of(runs[k], options.quick));
    options.say(runs[k].name() + ": " + (old.is_null() ? "no golden " + file.string() : found.text));
    if (options.remake && !found.same && !results[k].contains("failed")) {
      fs::create_directories(file.parent_path());
      write_golden(file, results[k], old, options.reason);
      options.say(runs[k].name() + ": remade");
    } else {
      different += found.same ? 0 : 1;
    }
  }
  return different;
}

}  // namespace furrow::validation
