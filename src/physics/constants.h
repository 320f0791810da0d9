#pragma once

#include <limits>

namespace furrow {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace furrow
