// Values as TOML has them: the shortest digits that read back the same.
#pragma once

#include <concepts>
#include <cstdio>
#include <string>
#include <type_traits>

#include "scene/scene.h"
#include "scene/wording.h"

namespace furrow {

inline std::string toml_value(bool value) { return value ? "true" : "false"; }
std::string toml_value(std::integral auto value) { return std::to_string(value); }
inline std::string toml_value(double value) {
  const std::string digits = shortest(value);
  return digits.find_first_of(".ein") == std::string::npos ? digits + ".0" : digits;  // e, inf, nan: a float already
}

inline std::string toml_value(const Vec2& v) { return '[' + toml_value(v.x) + ", " + toml_value(v.y) + ']'; }

// Letters beyond ASCII stand as they are; controls, which no sound scene holds, by their number.
inline std::string toml_value(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    char code[8];
    const auto byte = static_cast<unsigned char>(c);
    std::snprintf(code, sizeof code, "\\u%04X", byte);
    text += byte < 0x20 || byte == 0x7F ? code : c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  }
  return text + '"';
}

// A value, not a table.
template <class T>
constexpr bool is_value = std::is_same_v<T, Vec2> || !std::is_aggregate_v<T>;

}  // namespace furrow
