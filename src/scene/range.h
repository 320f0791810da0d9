// What a number of a scene may be, and the words for one that is not.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
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

// "0 < step < inf"
inline std::string interval(const Range& range, const std::string& key) {
  return shortest(range.low) + (range.low_open ? " < " : " <= ") + key + (range.high_open ? " < " : " <= ") +
         shortest(range.high);
}

// "-1 is outside 0 < step < inf [s]", of the last key of a path.
inline std::string outside(const Range& range, const std::string& path, std::string_view unit, double number) {
  const std::string key = path.substr(path.rfind('.') + 1);
  return shortest(number) + " is outside " + interval(range, key) + in_brackets(unit);
}

// Of the integers in the range those that the reader takes: they fit the field, and TOML's have 64 bits and a sign.
template <class Integer>
Range integers_of(Range range) {
  constexpr auto toml = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  constexpr auto most =
      static_cast<double>(std::min(static_cast<std::uint64_t>(std::numeric_limits<Integer>::max()), toml));
  if (range.high > most) range.high = most, range.high_open = false;
  return range;
}

}  // namespace furrow
