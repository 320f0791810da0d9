// Pictures of a run at chosen times: CSV for figures, VTK (.vtp and a .pvd that lists them) for ParaView.
#pragma once

#include "output/files.h"
#include "run/system.h"
#include "system/history.h"

namespace furrow {

class Frames {
 public:
  // How far the lists have come, and what all pictures hold.
  struct Memory {
    std::size_t count = 0;
    FileMark list, pvd;
    std::vector<FileMark> pictures{};
    void history(HistoryVisitor& visit);
    // Throws FileError unless all are there as they were.
    void require(const std::filesystem::path& directory) const;
  };

  // Writes run.pvd into `directory`, all else into `directory` / frames, which must exist.
  // Goes on after what was kept, if there is anything.
  Frames(const std::filesystem::path& directory, const Memory* kept);
  Memory memory() { return {count_, list_.mark(), pvd_.mark(), pictures_}; }

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
  std::size_t count_ = 0;
  std::vector<FileMark> pictures_;
};

}  // namespace furrow
