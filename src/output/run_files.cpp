#include "output/run_files.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "output/build_info.h"
#include "output/file_list.h"
#include "output/first_touch.h"
#include "output/machine.h"
#include "output/owned_directory.h"
#include "output/run_checkpoint.h"
#include "output/series.h"
#include "output/validity_json.h"
#include "output/warnings.h"
#include "run/observe.h"
#include "run/prepare.h"
#include "run/stiffness.h"
#include "scene/hash.h"
#include "scene/read.h"
#include "system/floating_point.h"
#include "system/place.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

// Those that a run goes on with after so many frames.
std::vector<std::string> lasting_files(const Scene& scene, std::size_t frames) {
  std::vector<std::string> files = Frames::files(frames);
  for (const char* name :
       {"plate_force.csv", "wall_force.csv", "energy.csv", "motion.csv", "events.csv", checkpoint_name})
    files.emplace_back(name);
  if (drives_nodes(scene)) files.emplace_back("drive_force.csv");
  return files;
}

std::vector<std::string> files_of(const Scene& scene) {
  std::vector<std::string> files = lasting_files(scene, scene.output.frames.size());
  for (const char* name : {"state.csv", "scene.toml", "run.json"}) files.emplace_back(name);
  return files;
}

// When a run is saved.
class SaveClock {
 public:
  SaveClock(std::optional<double> interval, double now) : interval_(interval.value_or(infinity)) { saved(now); }
  bool is_due(double t) const { return t >= next_; }
  void saved(double t) { next_ = std::isfinite(interval_) ? (std::floor(t / interval_) + 1) * interval_ : infinity; }

 private:
  double interval_, next_ = infinity;  // s
};

void write_state(const fs::path& directory, const System& system, double t, const State& y) {
  const std::vector<Stress> stress = disc_stresses(system, t, y);
  const Parts& parts = system.parts();
  const NodeMotion nodes = system.nodes(t, y);
  OutputFile file(directory / "state.csv",
                  "body,index,x [m],y [m],vx [m/s],vy [m/s],spin [rad/s],radius [m],von Mises [Pa]");
  for (const int i : places_in(parts.disc.number)) {
    file.row("disc", parts.disc.number[i], y[system.x_of(i)], y[system.y_of(i)], y[system.vx_of(i)], y[system.vy_of(i)],
             system.spin(y, i), parts.disc.radius[i], von_mises(stress[i]));
  }
  for (int n = 0; n < parts.node.count(); ++n) {
    const char* kind = parts.node.drive[n] >= 0 ? "driven node" : parts.node.body[n] < 0 ? "fixed node" : "node";
    file.row(kind, n, nodes.x[n], nodes.y[n], nodes.vx[n], nodes.vy[n], "", "", "");
  }
  file.finish();
}

void write_text(const fs::path& file, const std::string& text) {
  OutputFile out(file);
  out << text;
  out.finish();
}

// How far settling is, and what it waits for.
std::string settling_words(const Settle& settle, double t, double speed) {
  const auto in_digits = [](double value) { return shortest(std::round(10 * value) / 10); };
  return "settling " + in_digits(t) + " s of the model, fastest " + in_digits(1e3 * speed) + " mm/s, waits for " +
         in_digits(1e3 * settle.speed) + " mm/s";
}

RunOutcome run_in_own_directory(const RunRequest& request, const SavedRun* saved) {
  const Scene& asked = request.scene;
  const Timing& time = asked.time;
  write_text(request.directory / "scene.toml", canonical_text(asked));

  const BuildInfo& build = build_info();
  nlohmann::ordered_json json{
      {"scene", request.scene_file},    {"title", asked.title},       {"scene_hash", hexadecimal(scene_hash(asked))},
      {"commit", build.commit},         {"compiler", build.compiler}, {"flags", build.flags},
      {"build_type", build.build_type}, {"sources", build.sources},   {"machine", processor_name()},
      {"method", time.method},          {"step", time.step},          {"end", time.end},
      {"seed", nlohmann::json::array()}};
  for (const Packing& p : asked.packing) json["seed"].push_back(p.seed);
  const auto conclude = [&](const std::string& ended, const std::string& reason, double at) {
    json["ended"] = ended;
    json["reason"] = reason;
    json["ended_at"] = at;
    std::vector<std::string> names = files_of(asked);
    std::erase_if(names, [](const std::string& name) { return name == "run.json" || name == checkpoint_name; });
    json["files"] = list_of_files(request.directory, names);
    const std::string text = sealed_text(json);
    write_text(request.directory / "run.json", text);
    return RunOutcome{ended, reason, text};
  };

  const bool shares = asked.search.threads > 1;
  const double began = cpu_seconds(shares);
  std::optional<Prepared> prepared;
  try {
    if (saved)
      prepared.emplace(saved->prepared());
    else
      prepared = prepare(asked, [&](double t, double speed) {
        return request.progress(settling_words(*asked.settle, t, speed), t, asked.settle->limit);
      });
  } catch (const Interrupted& stopped) {
    return conclude("interrupted", stopped.what(), 0);
  } catch (const Divergence& failure) {
    return conclude("diverged", failure.what(), 0);
  }
  System& system = prepared->system;
  State& y = prepared->y;
  json["discs"] = system.parts().disc.count();
  json["nodes"] = system.parts().node.count();
  json["links"] = system.parts().link.count();
  json["settling_time"] = prepared->settling_time;
  json["settling_steps"] = prepared->settling_steps;
  json["settling_cpu_seconds"] = cpu_seconds(shares) - began;
  json["surface"] = nullptr;
  if (prepared->surface) json["surface"] = *prepared->surface;
  std::vector<std::string> warnings;
  if (!saved) {
    warnings = warnings_before(asked);
    for (const auto& more : {prepared->warnings, warnings_of_lowered_plates(asked, prepared->scene)})
      warnings.insert(warnings.end(), more.begin(), more.end());
  }
  for (const std::string& warning : warnings) request.warn(warning);

  const double cpu = cpu_seconds(shares), wall = wall_seconds();
  Validity validity(system, prepared->scene, [&](const std::string& text) {
    warnings.push_back(text);
    request.warn(text);
  });
  Series series(request.directory, prepared->scene, saved ? &saved->series() : nullptr);
  const auto method = make_method(time.method, {time.relative_tolerance, time.absolute_tolerance, time.step});
  RunPoint point;
  FirstTouch touch;
  const UnderWay under_way{asked, *prepared, *method, point, series, touch, validity, warnings};
  if (saved) saved->restore(under_way);
  SaveClock clock(asked.output.checkpoint, point.time);
  bool end_in_sight = false;  // a run to a later end would go another way from here
  const auto save_now = [&] {
    save(request.directory, under_way);
    clock.saved(point.time);
  };
  const RunPlan plan{.start = 0,
                     .end = time.end,
                     .step = method->info().controlled ? time.max_step : time.step,
                     .stop = [&](double t) { return series.next_stop(t); },
                     .locate = time.locate,
                     .point = &point,
                     .before_end =
                         [&] {
                           save_now();
                           end_in_sight = true;
                         },
                     .validity = &validity,
                     .stops_when_interrupted = true};
  long steps = 0;
  const RunEnd end = run(system, *method, y, plan, [&](double t, const State& now, const JumpReport& report) {
    if (const std::optional<Observation> row = series.see(system, t, now, report)) validity.judge_row(t, *row);
    touch.see(system, t, now);
    if (point.steps == 0 || (clock.is_due(t) && !end_in_sight)) save_now();
    return ++steps % 64 != 0 || request.progress("running", t, time.end);
  });
  if (end.ending == Ending::stopped && !end.cut && !end_in_sight) save_now();
  series.end(system, end.time, y);
  series.close(end.ending != Ending::stopped);
  write_state(request.directory, system, end.time, y);
  validity.conclude();
  json["warnings"] = warnings;
  json["state_size"] = system.size();
  json["steps"] = end.steps;
  json["rhs_evaluations"] = method->evaluations() + end.event_evaluations;
  if (time.locate != Locate::none) json["events"] = end.events;
  json["rejected"] = method->rejections();
  json["cpu_seconds"] = cpu_seconds(shares) - cpu;
  json["wall_seconds"] = wall_seconds() - wall;
  json["state_hash"] = hexadecimal(system.state_hash(y));
  add_extremes(json, validity, prepared->scene);
  json["validity"] = validity_json(validity);
  json["plate_meets_lattice"] = nullptr;
  if (std::isfinite(touch.time())) json["plate_meets_lattice"] = touch.time();
  const bool was_asked = end.ending == Ending::stopped && interrupt_requested();
  return conclude(to_string(end.ending), was_asked ? interrupt_words() : end.reason, end.time);
}

}  // namespace

bool has_checkpoint(const fs::path& directory) { return fs::exists(directory / checkpoint_name); }

RunOutcome run_with_files(const RunRequest& request) {
  const DefaultFloatingPoint environment;
  if (request.resume) require_saved_run(request.directory, request.scene);
  OwnedDirectory directory(request.directory, "run", files_of(request.scene),
                           request.resume ? OwnedDirectory::Earlier::kept : OwnedDirectory::Earlier::replaced);
  std::optional<SavedRun> saved;
  if (request.resume) {
    saved.emplace(request.directory, request.scene);
    directory.keep_only(lasting_files(request.scene, saved->series().frames.count));
  }
  RunOutcome outcome = run_in_own_directory(request, saved ? &*saved : nullptr);
  directory.conclude(outcome.ended);
  return outcome;
}

}  // namespace furrow
