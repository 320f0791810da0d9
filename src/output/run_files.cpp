#include "output/run_files.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "output/build_info.h"
#include "output/files.h"
#include "output/frames.h"
#include "scene/read.h"
#include "system/observe.h"
#include "system/prepare.h"
#include "system/stiffness.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

std::string hexadecimal(std::uint64_t value) {
  std::ostringstream text;
  text << std::hex << value;
  return std::string(16 - std::min<std::size_t>(16, text.str().size()), '0') + text.str();
}

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

double cpu_seconds() {  // of this thread: runs go side by side
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Stopwatch {
 public:
  double cpu() const { return cpu_seconds() - cpu_; }
  double wall() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count(); }

 private:
  double cpu_ = cpu_seconds();
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

// An empty or new directory, or one with an earlier run, which is removed.
void claim_directory(const fs::path& directory) {
  std::error_code failed;
  if (fs::exists(directory, failed) && !fs::is_directory(directory, failed)) {
    throw FileError(directory.string() + " is not a directory");
  }
  if (fs::exists(directory, failed) && !fs::is_empty(directory, failed) &&
      !fs::exists(directory / "run.json", failed) && !fs::exists(directory / "run.json.partial", failed)) {
    throw FileError(directory.string() +
                    " is neither empty nor an earlier run (it has no run.json); choose another --out");
  }
  fs::create_directories(directory, failed);
  if (failed) throw FileError("cannot make " + directory.string() + ": " + failed.message());
  for (const char* name : {"plate_force.csv", "energy.csv", "motion.csv", "events.csv", "state.csv", "scene.toml",
                           "run.pvd", "run.json"}) {
    for (const char* ending : {"", ".partial"}) {
      fs::remove(directory / (std::string(name) + ending), failed);
      if (failed) throw FileError("cannot replace " + (directory / name).string() + ": " + failed.message());
    }
  }
  fs::remove_all(directory / "frames", failed);
  fs::create_directories(directory / "frames", failed);
  if (failed) throw FileError("cannot make " + (directory / "frames").string() + ": " + failed.message());
}

// Distance the first plate has gone; without a plate the time stands for nothing and this is 0.
double displacement(const System& system, double t) {
  if (system.parts().plate.empty()) return 0;
  const PlatePart& p = system.parts().plate.front();
  return std::sqrt(p.vx * p.vx + p.vy * p.vy) * t;
}

class Series {
 public:
  Series(const fs::path& directory, const Scene& scene)
      : scene_(scene),
        force_(directory / "plate_force.csv"),
        energy_(directory / "energy.csv"),
        motion_(directory / "motion.csv"),
        events_(directory / "events.csv"),
        frames_(directory) {
    force_ << "t [s],plate,displacement [m],Fx [N],Fy [N],F [N]\n";
    energy_ << "t [s],kinetic [J],gravity [J],load [J],springs [J],contact elastic [J],link damping [J],contact "
               "viscous [J],"
               "friction [J],rolling [J],tear [J],plate work [J],stiffening [J],residual [J]\n";
    motion_ << "t [s],px [kg m/s],py [kg m/s],L [kg m^2/s],contacts,overlap [m],relative overlap [-],speed [m/s]\n";
    events_ << "t [s],displacement [m],kind,lattice,row a,column a,row b,column b,fixed,force [N]\n";
  }

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
      const std::string& name = scene_.plate[k].name;
      force_.row(t, name.empty() ? std::to_string(k) : name, displacement(system, t), f.x, f.y, std::hypot(f.x, f.y));
    }
    const Energies& e = seen.energy;
    if (system.keeps_ledger()) {
      energy_.row(t, e.kinetic, e.gravity, e.load, e.springs, e.contact_elastic, e.link_damping, e.contact_viscous,
                  e.friction, e.rolling, e.tear, e.plate_work, e.stiffening, e.residual(start_));
    }
    motion_.row(t, seen.momentum.x, seen.momentum.y, seen.momentum.angular, seen.contacts, seen.overlap.depth,
                seen.overlap.relative, greatest_speed(system, y));
    if (seen.overlap.relative > greatest_.relative) greatest_ = seen.overlap;
  }

  void add_tear(const System& system, const Tear& tear) {
    const Parts& parts = system.parts();
    const NodeArrays& node = parts.node;
    const int a = parts.link.a[tear.link];
    const int b = parts.link.b[tear.link];
    const std::string& name = parts.lattice[node.lattice[a]].name;
    events_.row(tear.time, displacement(system, tear.time), to_string(parts.link.kind[tear.link]),
                name.empty() ? std::to_string(node.lattice[a]) : name, node.row[a], node.column[a], node.row[b],
                node.column[b], (node.body[a] < 0 ? 1 : 0) + (node.body[b] < 0 ? 1 : 0), tear.force);
  }

  const Scene& scene_;
  OutputFile force_, energy_, motion_, events_;
  Frames frames_;
  Energies start_;
  Overlap greatest_;
  long rows_ = 0;
  std::size_t pictures_ = 0;
};

void write_state(const fs::path& directory, const System& system, double t, const State& y) {
  const std::vector<Stress> stress = disc_stresses(system, t, y);
  const Parts& parts = system.parts();
  const System::Nodes nodes = system.nodes(y);
  OutputFile file(directory / "state.csv");
  file << "body,index,x [m],y [m],vx [m/s],vy [m/s],spin [rad/s],radius [m],von Mises [Pa]\n";
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
  claim_directory(request.directory);
  nlohmann::ordered_json json;
  json["scene"] = request.scene_file;
  json["title"] = asked.title;
  json["scene_hash"] = hexadecimal(scene_hash(asked));
  json["commit"] = build_info().commit;
  json["compiler"] = build_info().compiler;
  json["flags"] = build_info().flags;
  json["build_type"] = build_info().build_type;
  json["machine"] = processor_name();
  json["method"] = asked.time.method;
  json["step"] = asked.time.step;
  json["end"] = asked.time.end;
  json["seed"] = nlohmann::json::array();
  for (const Packing& p : asked.packing) json["seed"].push_back(p.seed);
  write_text(request.directory / "scene.toml", canonical_text(asked));

  RunOutcome outcome;
  RunEnd end;
  const auto conclude = [&]() {
    json["ended"] = outcome.ended;
    json["reason"] = outcome.reason;
    json["ended_at"] = end.time;
    outcome.json = json.dump(2) + "\n";
    write_text(request.directory / "run.json", outcome.json);
    return outcome;
  };
  const auto go_on = [&](const std::string& doing, double done, double total) {
    return !request.progress || request.progress(doing, done, total);
  };

  const Stopwatch preparation;
  std::optional<Prepared> prepared;
  try {
    prepared.emplace(prepare(asked, [&](double t, double) { return go_on("settling", t, asked.settle->limit); }));
  } catch (const Interrupted& stopped) {
    outcome = {"interrupted", stopped.what(), {}};
    return conclude();
  } catch (const Divergence& failure) {
    outcome = {"diverged", failure.what(), {}};
    return conclude();
  }
  System& system = prepared->system;
  State& y = prepared->y;
  json["discs"] = system.parts().disc.count();
  json["nodes"] = system.parts().node.count();
  json["links"] = system.parts().link.count();
  json["state_size"] = system.size();
  json["settling_time"] = prepared->settling_time;
  json["settling_steps"] = prepared->settling_steps;
  json["settling_cpu_seconds"] = preparation.cpu();
  json["surface"] = prepared->surface ? nlohmann::ordered_json(*prepared->surface) : nlohmann::ordered_json(nullptr);
  json["warnings"] = step_warnings(system, 0, y, asked.time.method, asked.time.step);
  for (const auto& warning : json["warnings"]) {
    if (request.warn) request.warn(warning.get<std::string>());
  }

  const Stopwatch running;
  Series series(request.directory, prepared->scene);
  const auto method =
      make_method(asked.time.method, {asked.time.relative_tolerance, asked.time.absolute_tolerance, asked.time.step});
  const RunPlan plan{.start = 0,
                     .end = asked.time.end,
                     .step = method->info().controlled ? asked.time.max_step : asked.time.step,
                     .stop = [&](double t) { return series.next_stop(t); }};
  long steps = 0;
  end = run(system, *method, y, plan, [&](double t, const State& now, const JumpReport& report) {
    series.see(system, t, now, report);
    return ++steps % 64 != 0 || go_on("running", t, asked.time.end);
  });
  series.close(end.ending != Ending::stopped);
  write_state(request.directory, system, end.time, y);
  json["steps"] = end.steps;
  json["rhs_evaluations"] = method->evaluations();
  json["rejected"] = method->rejections();
  json["cpu_seconds"] = running.cpu();
  json["wall_seconds"] = running.wall();
  json["state_hash"] = hexadecimal(system.state_hash(y));
  json["greatest_relative_overlap"] = series.greatest_overlap().relative;
  json["greatest_overlap_between"] = series.greatest_overlap().between;
  outcome.ended = end.ending == Ending::finished  ? "finished"
                  : end.ending == Ending::stopped ? "interrupted"
                                                  : "diverged";
  outcome.reason = end.reason;
  return conclude();
}

}  // namespace furrow
