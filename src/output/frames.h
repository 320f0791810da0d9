// Pictures of a run at chosen times: CSV for figures, VTK (.vtp and a .pvd that lists them) for ParaView.
#pragma once

#include <filesystem>
#include <vector>

#include "system/system.h"

namespace furrow {

class Frames {
 public:
  // Writes into `directory` / frames, which must exist.
  explicit Frames(std::filesystem::path directory) : directory_(std::move(directory)) {}

  // displacement: of the first plate, m.
  void add(const System& system, double t, double displacement, const State& y);

  // Lists the frames: frames/frames.csv and run.pvd.
  void finish() const;

 private:
  struct Frame {
    double t, displacement;
  };
  std::filesystem::path directory_;
  std::vector<Frame> frames_;
};

}  // namespace furrow
