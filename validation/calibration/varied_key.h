// What a calibration varies: keys of scenes, each over a range or a list of values.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace furrow::validation {

// A scene that is calibrated, by the name of its file.
struct Case {
  std::string name;
  Scene scene;
};

struct VariedKey {
  // "KEY=low:high", "KEY=low:high:log" or "KEY=a,b,c". KEY may be several keys that share the value, with commas
  // between them, and each may stand for one scene alone: "scenario_3:lattice[0].origin.x". Throws
  // std::invalid_argument.
  static VariedKey of(const std::string& text);

  struct Path {
    std::string scene, path;  // scene empty: all that have such a part
  };
  std::string name;  // as given, before the "="
  std::vector<Path> paths;
  std::vector<std::string> values{};  // of a list
  double low = 0, high = 0;           // of a range
  bool logarithmic = false;
  bool whole = false;  // of a range: its values are integers, those of the key
  bool listed() const { return !values.empty(); }
  // All listed values, or the two of a range.
  std::vector<std::string> ends() const;

  // The value that lies this share of the way from low to high, as a scene file writes it, and back.
  std::string at(double share) const;
  double share_of(const std::string& value) const;

  // The values about one that lie as far off as that share of the range on each side, as far as the range goes. Of
  // integers they are others than that one.
  std::string below(const std::string& value, double share) const;
  std::string above(const std::string& value, double share) const;
};

// A value of each key, in the order of the keys.
using Setting = std::vector<std::string>;

// The scene with a setting, its packings drawn by their seeds plus `packing`. Throws std::invalid_argument if a key that
// the scene has does not take its value.
Scene scene_with(const Case& of, const std::vector<VariedKey>& keys, const Setting& setting, int packing);

// Finds which keys are integers. Throws std::invalid_argument if a key belongs to no scene, varies nothing or what another
// varies too, or if a scene cannot be run at an end of a range or with a listed value.
void judge_keys(std::vector<VariedKey>& keys, const std::vector<Case>& cases);

// All combinations of listed values; keys with a range are in their middle.
std::vector<Setting> combinations(const std::vector<VariedKey>& keys);

// "contact.friction=0.3, lattice[0].tear=tension"
std::string text_of(const std::vector<VariedKey>& keys, const Setting& setting);

}  // namespace furrow::validation
