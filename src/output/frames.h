// Pictures of a run at chosen times: CSV for figures, VTK (.vtp and a .pvd that lists them) for ParaView.
#pragma once

#include "output/files.h"
#include "system/system.h"

namespace furrow {

class Frames {
 public:
  // Writes run.pvd into `directory`, all else into `directory` / frames, which must exist.
  explicit Frames(const std::filesystem::path& directory);

  // displacement: of the first plate, m; 0 without a plate.
  void add(const System& system, double t, double displacement, const State& y);

  // Ends the lists of frames, frames/frames.csv and run.pvd. Of a run that is not complete they keep the ending
  // .partial.
  void close(bool complete);

  // All that so many frames write, relative to the directory.
  static std::vector<std::string> files(std::size_t frames);

 private:
  std::filesystem::path directory_;
  OutputFile list_, pvd_;
  int count_ = 0;
};

}  // namespace furrow
