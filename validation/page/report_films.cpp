#include "validation/page/report_films.h"

#include <cmath>

namespace furrow::validation {
namespace {

// Displacements of the plate where the stills are. mm
std::vector<double> places_of(const RunRecord& run, const std::vector<double>& stills) {
  std::vector<double> places;
  for (const double t : stills) places.push_back(plate_displacement(run, t));
  return places;
}

}  // namespace

std::vector<Film> films_of(const ReportedRun& reported, const RunRecord& run) {
  std::vector<Film> films;
  const auto add = [&](const std::string& id, const std::string& label, const RunRecord& shown,
                       const std::filesystem::path& directory) {
    if (shown.frames.size() >= least_film)
      films.push_back({id, label, film_of(shown, directory, places_of(run, reported.stills))});
  };
  add("film_" + run.name, "the literal reading, 0.1 ms, as on this page", run, reported.directory);
  for (std::size_t k = 0; k < reported.others.size() && !films.empty(); ++k) {
    const OtherRun& other = reported.others[k];
    if (!other.plays) continue;
    const RunRecord record = read_run(run.name, other.directory);
    add("film_" + run.name + "_" + std::to_string(k + 1), other.label + (record.finished() ? "" : ", ended early"),
        record, other.directory);
  }
  return films;
}

void add_tool_films(const std::vector<OtherRun>& tools, Films& films) {
  for (const OtherRun& tool : tools) {
    const RunRecord run = read_run("tool", tool.directory);
    const std::string id = "film_tool_" + std::to_string(films["tool"].size() + 1);
    if (run.frames.size() >= least_film) films["tool"].push_back({id, tool.label, film_of(run, tool.directory, {})});
  }
  if (films["tool"].empty()) films.erase("tool");
}

std::vector<RunByStep> by_step(const ReportedRun& reported, const RunRecord& run) {
  std::vector<RunByStep> all{{run.scene.time.step, run.force}};
  for (const OtherRun& other : reported.others) {
    if (!other.same_but_step) continue;
    const RunRecord record = read_run(run.name, other.directory);
    if (record.finished()) all.push_back({record.scene.time.step, record.force});
  }
  return all;
}

void keep_stills(RunRecord& run, const std::vector<double>& stills) {
  if (stills.empty()) return;
  const double near = plate_speed(run) * 2 * run.scene.time.step + 1e-9;  // mm
  std::vector<Frame> kept;
  for (const double place : places_of(run, stills)) {
    for (Frame& frame : run.frames) {
      if (std::fabs(frame.mm - place) > near) continue;
      kept.push_back(std::move(frame));
      break;
    }
  }
  run.frames = std::move(kept);
  run.scene.output.frames = stills;
}

}  // namespace furrow::validation
