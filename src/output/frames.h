// Pictures of a run at chosen times: CSV for figures, VTK (.vtp and a .pvd that lists them) for ParaView.
#pragma once

#include "output/files.h"
#include "system/system.h"

namespace furrow {

class Frames {
 public:
  // Writes into `directory` / frames, which must exist.
  explicit Frames(const std::filesystem::path& directory);

  // displacement: of the first plate, m.
  void add(const System& system, double t, double displacement, const State& y);

  // Completes the lists of frames, frames/frames.csv and run.pvd.
  void finish();

 private:
  std::filesystem::path directory_;
  OutputFile list_, pvd_;
  int count_ = 0;
};

}  // namespace furrow
