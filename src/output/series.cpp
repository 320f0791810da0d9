#include "output/series.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "methods/method.h"
#include "output/machine.h"
#include "scene/labels.h"

namespace furrow {
namespace {

// s of the clock. To write each row by itself took a seventh of the first scene's time.
constexpr double flush_every = 0.05;

double displacement(const PlatePart& plate, double t) {
  return std::sqrt(plate.vx * plate.vx + plate.vy * plate.vy) * ramped(t, plate.ramp).time;
}

// Without a plate the time stands for nothing and this is 0.
double displacement_of_first(const System& system, double t) {
  const std::vector<PlatePart>& plates = system.parts().plate;
  return plates.empty() ? 0 : displacement(plates.front(), t);
}

}  // namespace

bool drives_nodes(const Scene& scene) {
  return std::any_of(scene.lattice.begin(), scene.lattice.end(), [](const Lattice& l) { return !l.drive.empty(); });
}

void SeriesMemory::history(HistoryVisitor& visit) {
  force.history(visit, "plate_force.csv");
  drive.history(visit, "drive_force.csv");
  wall.history(visit, "wall_force.csv");
  energy.history(visit, "energy.csv");
  motion.history(visit, "motion.csv");
  events.history(visit, "events.csv");
  frames.history(visit);
  visit("rows", rows);
  visit("last", last);
  start.history(visit);
}

void SeriesMemory::require(const std::filesystem::path& directory, const Scene& scene) const {
  const std::vector<std::pair<const char*, const FileMark*>> files{{"plate_force.csv", &force},
                                                                   {"wall_force.csv", &wall},
                                                                   {"energy.csv", &energy},
                                                                   {"motion.csv", &motion},
                                                                   {"events.csv", &events}};
  for (const auto& [name, mark] : files) OutputFile::require(directory / name, *mark);
  if (drives_nodes(scene)) OutputFile::require(directory / "drive_force.csv", drive);
  frames.require(directory);
}

Series::Series(const std::filesystem::path& directory, const Scene& scene, const SeriesMemory* kept)
    : scene_(scene),
      due_(make_method(scene.time.method)->info(), scene.time.step, scene.output.interval),
      plates_(labels(scene.plate)),
      walls_(labels(scene.wall)),
      lattices_(labels(scene.lattice)),
      force_(OutputFile::begun(directory / "plate_force.csv", "t [s],plate,displacement [m],Fx [N],Fy [N],F [N]",
                               kept ? &kept->force : nullptr)),
      wall_force_(OutputFile::begun(directory / "wall_force.csv", "t [s],wall,Fx [N],Fy [N],F [N]",
                                    kept ? &kept->wall : nullptr)),
      energy_(OutputFile::begun(
          directory / "energy.csv",
          "t [s],kinetic [J],gravity [J],load [J],springs [J],contact elastic [J],link damping [J],"
          "contact viscous [J],friction [J],rolling [J],tear [J],plate work [J],stiffening [J],residual [J]",
          kept ? &kept->energy : nullptr)),
      motion_(OutputFile::begun(
          directory / "motion.csv",
          "t [s],px [kg m/s],py [kg m/s],L [kg m^2/s],contacts,overlap [m],relative overlap [-],speed [m/s]",
          kept ? &kept->motion : nullptr)),
      events_(OutputFile::begun(directory / "events.csv",
                                "t [s],displacement [m],kind,lattice,row a,column a,row b,column b,fixed,force [N]",
                                kept ? &kept->events : nullptr)),
      frames_(directory, kept ? &kept->frames : nullptr) {
  if (drives_nodes(scene))
    drive_.reset(new OutputFile(OutputFile::begun(  // NOLINT(modernize-make-unique): it cannot be moved
        directory / "drive_force.csv", "t [s],lattice,drive,displacement [m],Fx [N],Fy [N],F [N]",
        kept ? &kept->drive : nullptr)));
  if (!kept) return;
  due_.restore(kept->rows);
  last_ = kept->last;
  start_ = kept->start;
  pictures_ = kept->frames.count;
}

SeriesMemory Series::memory() {
  return {force_.mark(),
          wall_force_.mark(),
          drive_ ? drive_->mark() : FileMark(),
          energy_.mark(),
          motion_.mark(),
          events_.mark(),
          frames_.memory(),
          due_.taken(),
          last_,
          start_};
}

std::optional<Observation> Series::see(const System& system, double t, const State& y, const JumpReport& report) {
  for (const Tear& tear : report.torn) add_tear(system, tear);
  std::optional<Observation> row;
  if (due_.at(t)) {
    row = add_rows(system, t, y);
    due_.take(t);
  }
  const std::vector<double>& times = scene_.output.frames;
  while (pictures_ < times.size() && t >= times[pictures_] - due_.slack()) {
    frames_.add(system, t, displacement_of_first(system, t), y);
    ++pictures_;
  }
  return row;
}

double Series::next_stop(double t) const {
  double next = std::min(scene_.time.end, due_.next());
  if (pictures_ < scene_.output.frames.size()) next = std::min(next, scene_.output.frames[pictures_]);
  return next > t ? next : scene_.time.end;
}

void Series::end(const System& system, double t, const State& y) {
  if (t != last_) add_rows(system, t, y);
}

void Series::close(bool complete) {
  for (OutputFile* file : files()) complete ? file->finish() : file->close();
  frames_.close(complete);
}

std::vector<OutputFile*> Series::files() {
  std::vector<OutputFile*> all{&force_, &wall_force_, &energy_, &motion_, &events_};
  if (drive_) all.push_back(&*drive_);
  return all;
}

void Series::add_drives(const System& system, double t, const std::vector<Force>& forces) {
  int last = -1, number = 0;  // of the drives of one lattice
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const DrivePart& d = system.parts().drive[k];
    number = d.lattice == last ? number + 1 : 0;
    last = d.lattice;
    drive_->row(t, lattices_[d.lattice], number, std::hypot(d.vx, d.vy) * ramped(t, d.ramp).time, forces[k].x,
                forces[k].y, std::hypot(forces[k].x, forces[k].y));
  }
}

Observation Series::add_rows(const System& system, double t, const State& y) {
  Observation seen = observe(system, t, y);
  if (last_ < 0) start_ = seen.energy;
  last_ = t;
  for (std::size_t k = 0; k < seen.plate.size(); ++k) {
    const Force& f = seen.plate[k];
    force_.row(t, plates_[k], displacement(system.parts().plate[k], t), f.x, f.y, std::hypot(f.x, f.y));
  }
  if (drive_) add_drives(system, t, seen.drive);
  for (std::size_t k = 0; k < seen.wall.size(); ++k)
    wall_force_.row(t, walls_[k], seen.wall[k].x, seen.wall[k].y, std::hypot(seen.wall[k].x, seen.wall[k].y));
  const Energies& e = seen.energy;
  if (system.keeps_ledger()) {
    energy_.row(t, e.kinetic, e.gravity, e.load, e.springs, e.contact_elastic, e.link_damping, e.contact_viscous,
                e.friction, e.rolling, e.tear, e.plate_work, e.stiffening, e.residual(start_));
  }
  motion_.row(t, seen.momentum.x, seen.momentum.y, seen.momentum.angular, seen.contacts, seen.overlap.depth,
              seen.overlap.relative, greatest_speed(system, y));
  const double now = wall_seconds();
  if (now - flushed_ >= flush_every) {
    flushed_ = now;
    flush();
  }
  return seen;
}

void Series::flush() {
  for (OutputFile* file : files()) file->flush();
}

void Series::add_tear(const System& system, const Tear& tear) {
  const Parts& parts = system.parts();
  const NodeArrays& node = parts.node;
  const int a = parts.link.a[tear.link];
  const int b = parts.link.b[tear.link];
  events_.row(tear.time, displacement_of_first(system, tear.time), to_string(parts.link.kind[tear.link]),
              lattices_[node.lattice[a]], node.row[a], node.column[a], node.row[b], node.column[b],
              (node.body[a] < 0 ? 1 : 0) + (node.body[b] < 0 ? 1 : 0), tear.force);
}

}  // namespace furrow
