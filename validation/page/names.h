// One name for each thing, in words.
#pragma once

#include <algorithm>
#include <string>

namespace furrow::validation {

// "scenario_1" is "scene 1", "single_spring" is "single spring".
inline std::string scene_words(std::string name) {
  if (name.starts_with("scenario_")) name.replace(0, 9, "scene ");
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace furrow::validation
