// A vector of length 1 from one of any length but zero.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/scene.h"

namespace furrow {

// Scaled by a power of two first, which changes no bit unless a square would have over- or underflown.
inline Vec2 unit_vector(Vec2 v) {
  const int exponent = std::ilogb(std::max(std::fabs(v.x), std::fabs(v.y)));
  const double x = std::scalbn(v.x, -exponent), y = std::scalbn(v.y, -exponent);
  const double length = std::sqrt(x * x + y * y);
  return {x / length, y / length};
}

}  // namespace furrow
