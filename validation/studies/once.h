// Runs of a search that several of its parts ask for.
#pragma once

#include <map>
#include <set>

#include "validation/studies/reading_search.h"

namespace furrow::validation {

// Each run once, whoever asks for it.
class Once {
 public:
  explicit Once(const RunTasks& run) : run_(run) {}
  void make(const std::vector<Task>& tasks) {
    std::vector<Task> wanted;
    std::set<std::string> keys;
    for (const Task& task : tasks) {
      if (!known_.contains(task.key) && keys.insert(task.key).second) wanted.push_back(task);
    }
    const std::vector<Json> results = run_(wanted);
    for (std::size_t k = 0; k < wanted.size(); ++k) known_[wanted[k].key] = results[k];
  }
  bool knows(const std::string& key) const { return known_.contains(key); }
  const Json& of(const std::string& key) const { return known_.at(key); }

 private:
  const RunTasks& run_;
  std::map<std::string, Json> known_{};
};

}  // namespace furrow::validation
