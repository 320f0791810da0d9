// What the page says of a run, from its record.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "validation/page/names.h"
#include "validation/page/run_record.h"

namespace furrow::validation {

// "Scene 1: ...", see names.h.
inline std::string title_of(const RunRecord& run) { return scene_title(run.name, run.scene.title); }

// Null if it was not watched.
inline const WatchedFact* watch_of(const RunRecord& run, std::string_view name) {
  const auto found = std::find_if(run.watched.begin(), run.watched.end(),
                                  [&](const WatchedFact& w) { return w.name == name && !std::isnan(w.time); });
  return found == run.watched.end() ? nullptr : &*found;
}

}  // namespace furrow::validation
