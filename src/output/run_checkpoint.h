// What a run keeps in its directory to be resumed from: the file `checkpoint`. It holds all that outlasts a step:
// state, discrete state, history of the method, where the run stands, how far its files have come. The prepared scene
// is not in it, for it follows from the scene and the height of the settled bed, both of which are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "output/checkpoint.h"
#include "output/first_touch.h"
#include "output/series.h"
#include "run/prepare.h"
#include "run/run.h"

namespace furrow {

inline constexpr const char* checkpoint_name = "checkpoint";

// A run under way.
struct UnderWay {
  const Scene& asked;
  Prepared& prepared;
  Method& method;
  RunPoint& point;
  Series& series;
  FirstTouch& touch;
  Validity& validity;
  std::vector<std::string>& warnings;  // of its beginning
};

// Between two steps. Throws FileError.
void save(const std::filesystem::path& directory, const UnderWay& run);

// Throws as SavedRun does, and FileError if there is no checkpoint.
void require_saved_run(const std::filesystem::path& directory, const Scene& asked);

class SavedRun {
 public:
  // Of the run in the directory, if a run of `asked` can go on from there: the same scene and settings, but for what
  // comes later, how it is searched and how often it is saved. Else it throws std::invalid_argument, which says what is
  // not the same, or FileError.
  SavedRun(const std::filesystem::path& directory, const Scene& asked);

  double time() const { return time_; }  // s
  const SeriesMemory& series() const { return series_; }
  Prepared prepared() const;  // with the state and the discrete state of then

  // Everything in `run` but the asked, the prepared and the series.
  void restore(const UnderWay& run) const;

 private:
  const Scene& asked_;
  Checkpoint file_;
  double time_ = 0;  // s
  SeriesMemory series_;
};

}  // namespace furrow
