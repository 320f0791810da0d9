#include "output/run_checkpoint.h"

#include <sstream>

#include "output/build_info.h"
#include "scene/packing.h"
#include "scene/read.h"

namespace furrow {
namespace {

// What two runs must have in common for one to go on as the other: how a run ends, and what is due later, is open.
struct Identity {
  std::string program, scene;
  double time = 0;  // s
  void history(HistoryVisitor& visit) {
    visit("program", program);
    visit("time", time);
    visit("scene", scene);
  }
};

// Equal sources give equal bits.
std::string program_here() {
  const BuildInfo& build = build_info();
  return std::string(build.version) + " (sources " + std::string(build.sources) + ")";
}

Identity identity_of(Scene scene, double t) {
  scene.time.end = 0;
  scene.search = {};
  scene.output.checkpoint.reset();
  std::erase_if(scene.output.frames, [&](double frame) { return frame > t; });
  return {program_here(), canonical_text(scene), t};
}

// The next line that says something; a table goes with its first key.
std::string next_said(std::istream& text) {
  std::string line, key;
  while (std::getline(text, line) && line.empty()) {
  }
  if (!text) return "nothing more";
  const auto after = text.tellg();
  if (line.starts_with("[") && std::getline(text, key) && !key.empty()) line += " " + key;
  text.clear();
  text.seekg(after);
  return line;
}

// "[time] step = 1e-4", of the first line that is in one text only; both texts have their keys in the same order.
std::string first_difference(const std::string& there, const std::string& here) {
  std::istringstream one(there), other(here);
  std::string table;
  while (true) {
    const std::string a = next_said(one), b = next_said(other);
    const bool of_table = !a.starts_with("[") && !b.starts_with("[") && !table.empty();
    if (a != b || one.eof()) return (of_table ? table + " " : "") + a + "', here '" + b;
    if (a.starts_with("[")) table = a.substr(0, a.find(' '));
  }
}

// Height of the bed and what settling took.
CheckpointPart preparation_of(Prepared& prepared) {
  return {"preparation", [&](HistoryVisitor& visit) {
            bool settled = prepared.surface.has_value();
            double surface = prepared.surface.value_or(0);
            visit("settled", settled);
            visit("surface", surface);
            if (settled) prepared.surface = surface;
            visit("settling time", prepared.settling_time);
            visit("settling steps", prepared.settling_steps);
          }};
}

CheckpointPart state_of(Prepared& prepared) {
  return {"state", [&](HistoryVisitor& visit) {
            DiscreteState discrete = prepared.system.discrete_state();
            visit("y", prepared.y);
            discrete.history(visit);
            prepared.system.restore(discrete);
          }};
}

CheckpointPart series_of(SeriesMemory& series) {
  return {"series", [&](HistoryVisitor& visit) { series.history(visit); }};
}

std::vector<CheckpointPart> others_of(const UnderWay& run) {
  return {{"method", [&](HistoryVisitor& visit) { run.method.history(visit); }},
          {"point", [&](HistoryVisitor& visit) { run.point.history(visit); }},
          {"observers", [&](HistoryVisitor& visit) {
             run.touch.history(visit);
             run.validity.history(visit);
             visit.list("warnings", run.warnings, [&](std::string& text) { visit("warning", text); });
           }}};
}

}  // namespace

void save(const std::filesystem::path& directory, const UnderWay& run) {
  Identity identity = identity_of(run.asked, run.point.time);
  SeriesMemory series = run.series.memory();
  std::vector<CheckpointPart> parts{{"identity", [&](HistoryVisitor& visit) { identity.history(visit); }},
                                    preparation_of(run.prepared),
                                    state_of(run.prepared),
                                    series_of(series)};
  for (CheckpointPart& part : others_of(run)) parts.push_back(std::move(part));
  write_checkpoint(directory / checkpoint_name, parts);
}

void require_saved_run(const std::filesystem::path& directory, const Scene& asked) {
  if (!std::filesystem::exists(directory / checkpoint_name))
    throw FileError(directory.string() + " holds no checkpoint of a run to go on with");
  const SavedRun good(directory, asked);
}

SavedRun::SavedRun(const std::filesystem::path& directory, const Scene& asked)
    : asked_(asked), file_(directory / checkpoint_name) {
  Identity there;
  file_.read({"identity", [&](HistoryVisitor& visit) { there.history(visit); }});
  time_ = there.time;
  const Identity here = identity_of(asked, time_);
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument("the run in " + directory.string() + " cannot be gone on with: " + why);
  };
  if (there.program != here.program)
    refuse("it was made by furrow " + there.program + ", this is " + here.program + ", whose bits may be others");
  if (there.scene != here.scene)
    refuse("its scene is another one; there '" + first_difference(there.scene, here.scene) + "'");
  if (asked.time.end < time_)
    refuse("it has come to " + shortest(time_) + " s, and should end at " + shortest(asked.time.end) +
           " s: what is there would have to be taken back");
  file_.read(series_of(series_));
  series_.require(directory, asked);
}

Prepared SavedRun::prepared() const {
  Prepared facts{{}, System(Scene{}), {}, {}, 0, 0, {}};
  file_.read(preparation_of(facts));
  Prepared prepared = prepared_before(asked_, facts.surface);
  prepared.settling_time = facts.settling_time;
  prepared.settling_steps = facts.settling_steps;
  file_.read(state_of(prepared));
  if (prepared.y.size() != prepared.system.size())
    throw FileError("the checkpoint's state has " + std::to_string(prepared.y.size()) + " numbers, the scene's has " +
                    std::to_string(prepared.system.size()));
  return prepared;
}

void SavedRun::restore(const UnderWay& run) const {
  for (const CheckpointPart& part : others_of(run)) file_.read(part);
}

}  // namespace furrow
