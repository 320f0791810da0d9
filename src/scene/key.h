// What there is to say of a key of a scene file beside its name and its field.
#pragma once

#include <string_view>

#include "scene/range.h"

namespace furrow {

struct Key {
  std::string_view unit;     // "-": a ratio; empty: no number with a unit
  Range range;               // of each number in the value
  std::string_view example;  // its value as TOML; of a table none: those of its keys
  std::string_view meaning;  // whole sentences
};

inline constexpr Range any{};
inline constexpr Range finite{-infinity, infinity, true, true};
inline constexpr Range positive{0, infinity, true, true};
inline constexpr Range not_negative{0, infinity, false, true};

// A key that is no number: true or false, a name, a list of names.
constexpr Key plain(std::string_view example, std::string_view meaning) { return {"", any, example, meaning}; }
constexpr Key table(std::string_view meaning) { return {"", any, "", meaning}; }

// A word that a key may be, the value that it stands for, and what it means.
template <class Enum>
struct Choice {
  const char* word;
  Enum value;
  std::string_view meaning;
};

}  // namespace furrow
