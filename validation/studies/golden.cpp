#include "studies/golden.h"

#include <array>
#include <cinttypes>
#include <cmath>
#include <fstream>

#include "output/build_info.h"
#include "output/files.h"
#include "studies/beds.h"
#include "studies/study.h"
#include "system/observe.h"
#include "system/run.h"

namespace furrow::studies {
namespace {

namespace fs = std::filesystem;

struct Which {
  std::string scene;
  Reading reading;
  std::string name() const { return scene + "_" + to_string(reading); }
};

std::vector<Which> all_runs(bool quick) {
  std::vector<Which> all{{"scenario_3", Reading::disc}, {"scenario_2", Reading::disc}, {"scenario_1", Reading::disc}};
  if (!quick) all.insert(all.begin(), {{"scenario_3", Reading::sphere}, {"scenario_2", Reading::sphere}});
  return all;
}

constexpr double first_checkpoint = 0.1;  // s
constexpr double row_every = 0.05;        // s, between rows of the force curve

std::string hexadecimal(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, value);
  return text;
}

Json energies_of(const Energies& e) {
  return {{"kinetic", e.kinetic},         {"gravity", e.gravity},           {"springs", e.springs},
          {"contact", e.contact_elastic}, {"link_damping", e.link_damping}, {"contact_viscous", e.contact_viscous},
          {"friction", e.friction},       {"rolling", e.rolling},           {"tear", e.tear},
          {"plate_work", e.plate_work},   {"stiffening", e.stiffening}};
}

// A run as it is kept: force curve, tears, hashes at checkpoints, energies and positions at the end.
class Recorder {
 public:
  explicit Recorder(const System& system) : system_(system) {}

  void see(double t, const State& y, const JumpReport& jump) {
    for (const Tear& tear : jump.torn)
      golden_["tears"].push_back({tear.time, system_.parts().link_name(tear.link), tear.force});
    if (t < static_cast<double>(rows_) * row_every - 1e-9) return;
    const Force force = observe(system_, t, y).plate.at(0);
    golden_["force"].push_back({t, force.x, force.y});
    if (rows_ == 0 || std::fabs(t - first_checkpoint) < 1e-9) add_checkpoint(t, y);
    ++rows_;
  }

  void add_checkpoint(double t, const State& y) {
    golden_["checkpoints"].push_back({t, hexadecimal(system_.state_hash(y))});
  }

  Json finished(const RunEnd& end, const State& y) {
    add_checkpoint(end.time, y);
    golden_["ended"] = end.ending == Ending::diverged ? "diverged: " + end.reason : "finished";
    golden_["energies"] = energies_of(observe(system_, end.time, y).energy);
    for (int body = 0; body < system_.parts().bodies(); ++body)
      golden_["positions"].push_back({y[system_.x_of(body)], y[system_.y_of(body)]});
    return golden_;
  }

 private:
  const System& system_;
  Json golden_{{"checkpoints", Json::array()}, {"force", Json::array()}, {"tears", Json::array()}};
  long rows_ = 0;
};

Json run_of(const Which& which, bool quick) {
  Scene scene = paper_scene(which.scene, which.reading, 1);
  scene.output.energy = true;
  Prepared prepared = prepare(scene);
  System& system = prepared.system;
  const bool to_first_checkpoint = quick && which.scene != "scenario_1";
  Recorder recorder(system);
  const auto method = make_method(scene.time.method);
  const RunPlan plan{.start = 0, .end = scene.time.end, .step = scene.time.step, .stop = {}};
  // Stopped there, not ended there: the last step of a run is cut to its end and has other bits than a whole one.
  const RunEnd ended = run(system, *method, prepared.y, plan, [&](double t, const State& y, const JumpReport& jump) {
    recorder.see(t, y, jump);
    return !to_first_checkpoint || t < first_checkpoint - 1e-9;
  });
  return recorder.finished(ended, prepared.y);
}

// The first checkpoint whose bits differ; empty if none of those that both runs have do.
std::string first_difference(const Json& now, const Json& golden) {
  const Json& a = now.at("checkpoints");
  const Json& b = golden.at("checkpoints");
  for (const Json& mine : a) {
    for (const Json& theirs : b) {
      if (mine[0] == theirs[0] && mine[1] != theirs[1])
        return "at t = " + number(mine[0].get<double>()) + " s: " + mine[1].get<std::string>() + ", golden " +
               theirs[1].get<std::string>();
    }
  }
  return a.size() < 2 || b.size() < 2 ? "too few checkpoints to compare" : "";
}

// How far the numbers moved, in units of a tolerance of 1e-6 of the largest of their kind: what a reader would see in a
// figure is some thousand of them, round-off some millionth.
std::string moved(const Json& now, const Json& golden) {
  const auto numbers = [](const Json& rows, std::size_t column) {
    std::vector<double> all;
    for (const Json& row : rows) all.push_back(row.at(column));
    return all;
  };
  std::string text;
  for (const auto& [key, column, what] :
       {std::tuple{"force", 1, "Fx"}, {"force", 2, "Fy"}, {"positions", 0, "x"}, {"positions", 1, "y"}}) {
    const std::vector<double> a = numbers(now.at(key), column);
    const std::vector<double> b = numbers(golden.at(key), column);
    double scale = 0;
    double most = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
      scale = std::max(scale, std::fabs(b[k]));
      most = std::max(most, std::fabs(a[k] - b[k]));
    }
    text += (text.empty() ? "" : ", ") + std::string(what) + " by " +
            (scale > 0 ? number(std::round(most / (1e-6 * scale))) : "0");
  }
  return text + " tolerances; tears " + std::to_string(now.at("tears").size()) + ", golden " +
         std::to_string(golden.at("tears").size());
}

Json golden_in(const fs::path& file) {
  std::ifstream stream(file);
  return stream ? Json::parse(stream, nullptr, false) : Json();
}

void write_golden(const fs::path& file, Json golden, const Json& old, const std::string& reason) {
  const BuildInfo& build = build_info();
  golden["commit"] = build.commit;
  golden["compiler"] = build.compiler;
  golden["flags"] = build.flags;
  golden["reasons"] = old.is_object() && old.contains("reasons") ? old["reasons"] : Json::array();
  golden["reasons"].push_back(reason);
  OutputFile out(file);
  out << golden.dump() << "\n";
  out.finish();
}

// One line about a run; true if it is as the golden.
bool compare(const Which& which, const Json& now, const Json& golden, bool whole, const GoldenOptions& options) {
  const auto say = [&](const std::string& text) { options.say(which.name() + ": " + text); };
  if (now.contains("failed")) return say("did not run: " + now["failed"].get<std::string>()), false;
  if (!golden.is_object() || !golden.contains("checkpoints")) return say("no golden, or not a golden"), false;
  const std::string difference = first_difference(now, golden);
  if (difference.empty()) {
    const bool same = !whole || now["ended"] == golden["ended"];
    return say(same ? "the same bits" : "ended otherwise: " + now["ended"].get<std::string>()), same;
  }
  return say("differs " + difference + "; moved " + (whole ? moved(now, golden) : "")), false;
}

}  // namespace

int check_goldens(const GoldenOptions& options) {
  if (options.remake && options.reason.empty()) throw std::invalid_argument("golden --remake needs a --reason");
  if (options.remake && options.quick) throw std::invalid_argument("golden --remake needs whole runs, not --quick");
  const std::vector<Which> runs = all_runs(options.quick);
  std::vector<Task> tasks;
  for (const Which& which : runs)
    tasks.push_back({which.name(), [&options, which] { return run_of(which, options.quick); }});
  const std::vector<Json> results =
      run_tasks("golden", {.quick = options.quick, .jobs = options.jobs, .progress = options.progress}, tasks);
  int different = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const fs::path file = options.directory / (runs[k].name() + ".json");
    const Json old = golden_in(file);
    const bool whole = !options.quick || runs[k].scene == "scenario_1";
    const bool same = compare(runs[k], results[k], old, whole, options);
    if (options.remake && !same && !results[k].contains("failed")) {
      fs::create_directories(options.directory);
      write_golden(file, results[k], old, options.reason);
      options.say(runs[k].name() + ": made anew");
    } else {
      different += same ? 0 : 1;
    }
  }
  return different;
}

}  // namespace furrow::studies
