#include "output/run_files.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "output/build_info.h"
#include "output/first_touch.h"
#include "output/frames.h"
#include "output/machine.h"
#include "scene/read.h"
#include "system/observe.h"
#include "system/prepare.h"
#include "system/stiffness.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

std::string hexadecimal(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, value);
  return text;
}

// An empty or new directory, or one with an earlier run, which is removed.
void claim_directory(const fs::path& directory) {
  std::error_code failed;
  const auto exists = [&](const fs::path& path) { return fs::exists(path, failed); };
  const auto throw_if_failed = [&](const char* what, const fs::path& path) {
    if (failed) throw FileError(what + path.string() + ": " + failed.message());
  };
  const auto make = [&](const fs::path& path) {
    fs::create_directories(path, failed);
    throw_if_failed("cannot make ", path);
  };
  if (exists(directory) && !fs::is_directory(directory, failed))
    throw FileError(directory.string() + " is not a directory");
  if (exists(directory) && !fs::is_empty(directory, failed) && !exists(directory / "run.json") &&
      !exists(directory / "run.json.partial")) {
    throw FileError(directory.string() +
                    " is neither empty nor an earlier run (it has no run.json); choose another --out");
  }
  make(directory);
  for (const std::string name : {"plate_force.csv", "energy.csv", "motion.csv", "events.csv", "state.csv", "scene.toml",
                                 "run.pvd", "run.json"}) {
    for (const char* ending : {"", ".partial"}) {
      fs::remove(directory / (name + ending), failed);
      throw_if_failed("cannot replace ", directory / name);
    }
  }
  fs::remove_all(directory / "frames", failed);
  make(directory / "frames");
}

// Distance the first plate has gone; without a plate the time stands for nothing and this is 0.
double displacement(const System& system, double t) {
  if (system.parts().plate.empty()) return 0;
  const PlatePart& p = system.parts().plate.front();
  return std::sqrt(p.vx * p.vx + p.vy * p.vy) * t;
}

std::string name_or_index(const std::string& name, std::size_t index) {
  return name.empty() ? std::to_string(index) : name;
}

class Series {
 public:
  Series(const fs::path& directory, const Scene& scene)
      : scene_(scene),
        force_(directory / "plate_force.csv", "t [s],plate,displacement [m],Fx [N],Fy [N],F [N]"),
        energy_(directory / "energy.csv",
                "t [s],kinetic [J],gravity [J],load [J],springs [J],contact elastic [J],link damping [J],"
                "contact viscous [J],friction [J],rolling [J],tear [J],plate work [J],stiffening [J],residual [J]"),
        motion_(directory / "motion.csv",
                "t [s],px [kg m/s],py [kg m/s],L [kg m^2/s],contacts,overlap [m],relative overlap [-],speed [m/s]"),
        events_(directory / "events.csv",
                "t [s],displacement [m],kind,lattice,row a,column a,row b,column b,fixed,force [N]"),
        frames_(directory) {}

  // Rows and pictures that are due; a fixed step takes the accepted time nearest to what was asked for.
  void see(const System& system, double t, const State& y, const JumpReport& report) {
    for (const Tear& tear : report.torn) add_tear(system, tear);
    const double slack = 0.5 * scene_.time.step;
    if (t >= static_cast<double>(rows_) * scene_.output.interval - slack) {
      add_rows(system, t, y);
      rows_ = static_cast<long>(std::floor((t + slack) / scene_.output.interval)) + 1;
    }
    const std::vector<double>& times = scene_.output.frames;
    while (pictures_ < times.size() && t >= times[pictures_] - slack) {
      frames_.add(system, t, displacement(system, t), y);
      ++pictures_;
    }
  }

  double next_stop(double t) const {
    double next = std::min(scene_.time.end, static_cast<double>(rows_) * scene_.output.interval);
    if (pictures_ < scene_.output.frames.size()) next = std::min(next, scene_.output.frames[pictures_]);
    return next > t ? next : scene_.time.end;
  }

  void close(bool complete) {
    for (OutputFile* file : {&force_, &energy_, &motion_, &events_}) complete ? file->finish() : file->close();
    frames_.finish();
  }

  const Overlap& greatest_overlap() const { return greatest_; }

 private:
  void add_rows(const System& system, double t, const State& y) {
    const Observation seen = observe(system, t, y);
    if (rows_ == 0) start_ = seen.energy;
    for (std::size_t k = 0; k < seen.plate.size(); ++k) {
      const Force& f = seen.plate[k];
      force_.row(t, name_or_index(scene_.plate[k].name, k), displacement(system, t), f.x, f.y, std::hypot(f.x, f.y));
    }
    const Energies& e = seen.energy;
    if (system.keeps_ledger()) {
      energy_.row(t, e.kinetic, e.gravity, e.load, e.springs, e.contact_elastic, e.link_damping, e.contact_viscous,
                  e.friction, e.rolling, e.tear, e.plate_work, e.stiffening, e.residual(start_));
      check_books(seen);
    }
    motion_.row(t, seen.momentum.x, seen.momentum.y, seen.momentum.angular, seen.contacts, seen.overlap.depth,
                seen.overlap.relative, greatest_speed(system, y));
    if (seen.overlap.relative > greatest_.relative) greatest_ = seen.overlap;
  }

  // A method beyond its stability limit need not throw bodies out of the scene: links that turn bound what grows. A
  // hundredfold, since a stable method swings too: Verlet's energy by 1/(1 - (omega h/2)^2), a hundred at 0.995 of its
  // limit. Below a picojoule it may be round-off.
  void check_books(const Observation& seen) {
    constexpr double most = 100, round_off = 1e-12;  // -, J
    double in_a_step = 0;                            // J, of which the method cannot know yet when a plate touches
    for (std::size_t k = 0; k < seen.plate.size(); ++k) {
      const Vec2& v = scene_.plate[k].velocity;
      in_a_step += std::fabs(seen.plate[k].x * v.x + seen.plate[k].y * v.y) * scene_.time.step;
    }
    supplied_ = std::max(supplied_, seen.energy.supplied(start_) + in_a_step);
    const double live = seen.energy.live();
    if (live <= most * supplied_ + round_off) return;
    std::ostringstream text;
    text << "the scene moves and strains with " << live << " J, but was never given more than " << supplied_
         << " J: the method has made the rest, its step is too long (output.energy = false runs on without this check)";
    throw Divergence(text.str());
  }

  void add_tear(const System& system, const Tear& tear) {
    const Parts& parts = system.parts();
    const NodeArrays& node = parts.node;
    const int a = parts.link.a[tear.link];
    const int b = parts.link.b[tear.link];
    events_.row(tear.time, displacement(system, tear.time), to_string(parts.link.kind[tear.link]),
                name_or_index(parts.lattice[node.lattice[a]].name, node.lattice[a]), node.row[a], node.column[a],
                node.row[b], node.column[b], (node.body[a] < 0 ? 1 : 0) + (node.body[b] < 0 ? 1 : 0), tear.force);
  }

  const Scene& scene_;
  OutputFile force_, energy_, motion_, events_;
  Frames frames_;
  Energies start_;
  double supplied_ = 0;  // J, the most so far
  Overlap greatest_;
  long rows_ = 0;
  std::size_t pictures_ = 0;
};

void write_state(const fs::path& directory, const System& system, double t, const State& y) {
  const std::vector<Stress> stress = disc_stresses(system, t, y);
  const Parts& parts = system.parts();
  const System::Nodes nodes = system.nodes(y);
  OutputFile file(directory / "state.csv",
                  "body,index,x [m],y [m],vx [m/s],vy [m/s],spin [rad/s],radius [m],von Mises [Pa]");
  for (int i = 0; i < parts.disc.count(); ++i) {
    file.row("disc", i, y[system.x_of(i)], y[system.y_of(i)], y[system.vx_of(i)], y[system.vy_of(i)],
             system.has_friction() ? y[system.spin_of(i)] : 0, parts.disc.radius[i], von_mises(stress[i]));
  }
  for (int n = 0; n < parts.node.count(); ++n) {
    file.row(parts.node.body[n] < 0 ? "fixed node" : "node", n, nodes.x[n], nodes.y[n], nodes.vx[n], nodes.vy[n], "",
             "", "");
  }
  file.finish();
}

void write_text(const fs::path& file, const std::string& text) {
  OutputFile out(file);
  out << text;
  out.finish();
}

}  // namespace

RunOutcome run_with_files(const RunRequest& request) {
  const Scene& asked = request.scene;
  const Timing& time = asked.time;
  claim_directory(request.directory);
  write_text(request.directory / "scene.toml", canonical_text(asked));

  const BuildInfo& build = build_info();
  nlohmann::ordered_json json{{"scene", request.scene_file},
                              {"title", asked.title},
                              {"scene_hash", hexadecimal(scene_hash(asked))},
                              {"commit", build.commit},
                              {"compiler", build.compiler},
                              {"flags", build.flags},
                              {"build_type", build.build_type},
                              {"machine", processor_name()},
                              {"method", time.method},
                              {"step", time.step},
                              {"end", time.end},
                              {"seed", nlohmann::json::array()}};
  for (const Packing& p : asked.packing) json["seed"].push_back(p.seed);
  const auto conclude = [&](const std::string& ended, const std::string& reason, double at) {
    json["ended"] = ended;
    json["reason"] = reason;
    json["ended_at"] = at;
    write_text(request.directory / "run.json", json.dump(2) + "\n");
    return RunOutcome{ended, reason, json.dump(2) + "\n"};
  };

  const double began = cpu_seconds();
  std::optional<Prepared> prepared;
  try {
    prepared = prepare(asked, [&](double t, double) { return request.progress("settling", t, asked.settle->limit); });
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
  json["state_size"] = system.size();
  json["settling_time"] = prepared->settling_time;
  json["settling_steps"] = prepared->settling_steps;
  json["settling_cpu_seconds"] = cpu_seconds() - began;
  json["surface"] = nullptr;
  if (prepared->surface) json["surface"] = *prepared->surface;
  const std::vector<std::string> warnings = step_warnings(system, 0, y, time.method, time.step);
  json["warnings"] = warnings;
  for (const std::string& warning : warnings) request.warn(warning);

  const double cpu = cpu_seconds(), wall = wall_seconds();
  Series series(request.directory, prepared->scene);
  const auto method = make_method(time.method, {time.relative_tolerance, time.absolute_tolerance, time.step});
  const RunPlan plan{.start = 0,
                     .end = time.end,
                     .step = method->info().controlled ? time.max_step : time.step,
                     .stop = [&](double t) { return series.next_stop(t); },
                     .locate = time.locate};
  long steps = 0;
  FirstTouch touch;
  const RunEnd end = run(system, *method, y, plan, [&](double t, const State& now, const JumpReport& report) {
    series.see(system, t, now, report);
    touch.see(system, t, now);
    return ++steps % 64 != 0 || request.progress("running", t, time.end);
  });
  series.close(end.ending != Ending::stopped);
  write_state(request.directory, system, end.time, y);
  json["steps"] = end.steps;
  json["rhs_evaluations"] = method->evaluations() + end.event_evaluations;
  if (time.locate != Locate::none) json["events"] = end.events;
  json["rejected"] = method->rejections();
  json["cpu_seconds"] = cpu_seconds() - cpu;
  json["wall_seconds"] = wall_seconds() - wall;
  json["state_hash"] = hexadecimal(system.state_hash(y));
  json["greatest_relative_overlap"] = series.greatest_overlap().relative;
  json["greatest_overlap_between"] = series.greatest_overlap().between;
  json["plate_meets_lattice"] = nullptr;
  if (std::isfinite(touch.time())) json["plate_meets_lattice"] = touch.time();
  const bool finished = end.ending == Ending::finished, stopped = end.ending == Ending::stopped;
  return conclude(finished ? "finished" : stopped ? "interrupted" : "diverged", end.reason, end.time);
}

}  // namespace furrow
