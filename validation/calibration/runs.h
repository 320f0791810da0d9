// The runs of a calibration, each made once: kept by what goes into it, so that a search that begins again replays what
// it has.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <semaphore>
#include <string>
#include <vector>

#include "report/measurement.h"

namespace furrow::validation {

class Runs {
 public:
  // Kept in directory/runs.jsonl, a sealed line a run; an empty directory keeps nothing. `heard(runs made)` is called
  // after each run; false stops. Throws FileError if something else stands there.
  Runs(const std::filesystem::path& directory, unsigned jobs, std::function<bool(long)> heard = {});

  // The results in the order of the tasks, side by side; may be called from several threads. Tasks of the same input
  // share one run. What a run throws becomes {"failed": why}. Throws Interrupted, FileError.
  std::vector<Json> of(const std::vector<Task>& tasks);

  long made() const { return made_; }          // by this call of the program
  long replayed() const { return replayed_; }  // that were kept, and asked for

 private:
  void read(const std::filesystem::path& file);
  Json make(const Task& task);

  std::ofstream out_;
  std::counting_semaphore<> free_;
  std::function<bool(long)> heard_;
  std::mutex mutex_;
  std::map<std::string, Json> kept_;
  std::map<std::string, std::shared_future<Json>> results_;
  long made_ = 0, replayed_ = 0;
};

}  // namespace furrow::validation
