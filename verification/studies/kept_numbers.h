// How the studies of this folder keep numbers: so many significant digits; what is not finite as null.
#pragma once

#include <cmath>

#include "report/numbers.h"

namespace furrow::verification {

inline Json kept(double value, int digits) { return std::isfinite(value) ? Json(to_digits(value, digits)) : Json(); }

inline double number(const Json& json, double missing = NAN) { return json.is_number() ? json.get<double>() : missing; }

}  // namespace furrow::verification
