// Small pieces of HTML.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "scene/wording.h"

namespace furrow::validation {

inline const std::string missing = "<span class=\"missing\">missing</span>";

// Digits of a whole number: "4690", and from five digits on in groups, "10,690".
std::string in_groups(std::string digits);

// Three significant digits, or fewer where they say all, as HTML.
inline std::string shown(double value) {
  if (!std::isfinite(value)) return missing;
  const double size = std::abs(value);
  const int power = size > 0 ? static_cast<int>(std::floor(std::log10(size) + 1e-9)) : 0;
  const bool scientific = power < -4 || power > 6;
  const double mantissa = scientific ? size / std::pow(10.0, power) : size;
  std::string digits = fixed(mantissa, scientific ? 2 : std::max(0, 2 - power));
  if (digits.find('.') != std::string::npos && std::strtod(digits.c_str(), nullptr) == mantissa) {
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
  }
  const std::string exponent = (power < 0 ? "−" : "") + std::to_string(std::abs(power));
  if (digits.find('.') == std::string::npos) digits = in_groups(digits);
  return (value < 0 ? "−" : "") + digits + (scientific ? " × 10<sup>" + exponent + "</sup>" : "");
}

// Numbers within text as books print them: "-1" with a minus sign, "2e-06" as a power of ten, "1 ± 2 %" in one line,
// and "0.500000", as a program writes it, without what says nothing; whole numbers as in_groups has them.
std::string typeset(std::string html);

inline std::string with_unit(double value, const std::string& unit) {
  return std::isfinite(value) && !unit.empty() ? shown(value) + " " + unit : shown(value);
}

inline std::string element(const std::string& tag, const std::string& content, const std::string& kind = {}) {
  return "<" + tag + (kind.empty() ? "" : " class=\"" + kind + "\"") + ">" + content + "</" + tag + ">\n";
}

}  // namespace furrow::validation
