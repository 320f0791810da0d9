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
  void make(const std::vector<Wanted>& runs) {
    std::vector<Wanted> unknown;
    std::set<std::string> keys;
    for (const Wanted& run : runs) {
      if (!known_.contains(run.key) && keys.insert(run.key).second) unknown.push_back(run);
    }
    const std::vector<Json> results = run_(unknown);
    for (std::size_t k = 0; k < unknown.size(); ++k) known_[unknown[k].key] = results[k];
  }
  bool knows(const std::string& key) const { return known_.contains(key); }
  const Json& of(const std::string& key) const { return known_.at(key); }

 private:
  const RunTasks& run_;
  std::map<std::string, Json> known_{};
};

}  // namespace furrow::validation
