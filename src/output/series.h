// The series of a run: what is written row by row while it goes on, and its frames. Rows stay in
// memory for a twentieth of a second at most while more of them come; a disk that is full ends the run then.
//   plate_force.csv  each row with the displacement of its own plate
//   drive_force.csv  of a scene that drives nodes, each row with the displacement of its own drive
//   events.csv       torn links, with the displacement of the first plate; 0 without a plate
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "output/files.h"
#include "output/frames.h"
#include "output/schedule.h"
#include "run/observe.h"
#include "scene/scene.h"

namespace furrow {

// Whether the scene drives nodes of a lattice.
bool drives_nodes(const Scene& scene);

// How far a series has come.
struct SeriesMemory {
  FileMark force, wall, drive, energy, motion, events;
  Frames::Memory frames;
  long rows = 0;
  double last = -1;  // s, of the last row; -1: none yet
  Energies start;
  void history(HistoryVisitor& visit);

  // Throws FileError unless all that was written by then is still in the directory of the run.
  void require(const std::filesystem::path& directory, const Scene& scene) const;
};

class Series {
 public:
  // plate_force.csv, wall_force.csv, energy.csv, motion.csv, events.csv, frames/frames.csv and run.pvd of this scene, which must
  // outlive the series, in `directory`. They go on after what was kept, if there is anything.
  Series(const std::filesystem::path& directory, const Scene& scene, const SeriesMemory* kept = nullptr);

  // All rows so far are in the files.
  SeriesMemory memory();

  // Rows and frames that are due.
  // What the row at t says, if there is one.
  std::optional<Observation> see(const System& system, double t, const State& y, const JumpReport& report);

  // The next time at which something is due, for methods that choose their steps.
  double next_stop(double t) const;

  // The last state of a run is a row, also where none is due: t in s, y the last good state of one that diverged. After
  // the last memory(), which a run that goes on from there must not find it in.
  void end(const System& system, double t, const State& y);

  // Puts all rows into the files, as mark() of each promises.
  void flush();

  // Those of a run that is not complete keep the ending .partial.
  void close(bool complete);

 private:
  std::vector<OutputFile*> files();
  void add_drives(const System& system, double t, const std::vector<Force>& forces);
  Observation add_rows(const System& system, double t, const State& y);
  void add_tear(const System& system, const Tear& tear);

  const Scene& scene_;
  double flushed_ = 0;  // s, of the clock
  Due due_;
  double last_ = -1;                                    // s, of the last row
  std::vector<std::string> plates_, walls_, lattices_;  // what rows call them
  OutputFile force_, wall_force_, energy_, motion_, events_;
  std::unique_ptr<OutputFile> drive_;  // of a scene that drives nodes
  Frames frames_;
  Energies start_;
  std::size_t pictures_ = 0;
};

}  // namespace furrow
