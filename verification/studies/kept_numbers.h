// How the studies of this folder keep numbers: so many significant digits; what is not finite as null.
#pragma once

#include <charconv>
#include <cmath>

#include "report/numbers.h"
#include "scene/wording.h"

namespace furrow::verification {

inline Json kept(double value, int digits) {
  if (!std::isfinite(value)) return nullptr;
  const std::string text = furrow::rounded(value, digits);
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

inline double number(const Json& json, double missing = NAN) { return json.is_number() ? json.get<double>() : missing; }

}  // namespace furrow::verification
