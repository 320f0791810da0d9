// The series of a run: what is written row by row while it goes on, and its frames. Rows stay in
// memory for a twentieth of a second at most while more of them come; a disk that is full ends the run then.
//   plate_force.csv  each row with the displacement of its own plate
//   events.csv       torn links, with the displacement of the first plate; 0 without a plate
#pragma once

#include <filesystem>
#include <string>

#include "output/files.h"
#include "output/frames.h"
#include "scene/scene.h"
#include "system/validity.h"

namespace furrow {

class Series {
 public:
  // plate_force.csv, energy.csv, motion.csv, events.csv, frames/frames.csv and run.pvd of this scene, which must
  // outlive the series, in `directory`.
  // `validity` looks at the energy of each row.
  Series(const std::filesystem::path& directory, const Scene& scene, Validity& validity);

  // Rows and frames that are due; a fixed step takes the accepted time nearest to what was asked for, a method that
  // chooses its steps has ended one there.
  void see(const System& system, double t, const State& y, const JumpReport& report);

  // The next time at which something is due, for methods that choose their steps.
  double next_stop(double t) const;

  // Puts all rows into the files, as bytes() of each promises.
  void flush();

  // Those of a run that is not complete keep the ending .partial.
  void close(bool complete);

 private:
  void add_rows(const System& system, double t, const State& y);
  void add_tear(const System& system, const Tear& tear);

  const Scene& scene_;
  double flushed_ = 0;  // s, of the clock
  const double slack_;  // s
  Validity& validity_;
  std::vector<std::string> plates_, lattices_;  // what rows call them
  OutputFile force_, energy_, motion_, events_;
  Frames frames_;
  Energies start_;
  long rows_ = 0;
  std::size_t pictures_ = 0;
};

}  // namespace furrow
