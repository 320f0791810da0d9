// What a number of a scene may be, and the words for one that is not.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/wording.h"

namespace furrow {

struct Range {
  double low = -infinity;
  double high = infinity;
  bool low_open = false;  // low itself is not accepted
  bool high_open = false;
};

inline bool within(const Range& range, double number) {
  return (range.low_open ? number > range.low : number >= range.low) &&
         (range.high_open ? number < range.high : number <= range.high);
}

inline std::string in_brackets(std::string_view unit) {
  return unit.empty() || unit == "-" ? "" : " [" + std::string(unit) + "]";
}

// "-1 is outside 0 < step < inf [s]", of the last key of a path.
inline std::string outside(const Range& range, const std::string& path, std::string_view unit, double number) {
  const std::string key = path.substr(path.rfind('.') + 1);
  const std::string interval =
      shortest(range.low) + (range.low_open ? " < " : " <= ") + key + (range.high_open ? " < " : " <= ");
  return shortest(number) + " is outside " + interval + shortest(range.high) + in_brackets(unit);
}

}  // namespace furrow
