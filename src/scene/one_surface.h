// Which surfaces that lie on each other are one where plates are tight, see system/held_faces.h.
#pragma once

#include <algorithm>

#include "physics/geometry.h"
#include "scene/scene.h"

namespace furrow {

// Of two plates whose faces touch: they go together, and the face of one lies wholly on that of the other.
inline bool are_one_surface(const Scene& scene, const Plate& a, const Plate& b) {
  constexpr double most = 1 - 1e-9;
  const auto shared = [](double from, double length, double other, double other_length) {
    return std::min(from + length, other + other_length) - std::max(from, other);
  };
  const double across = shared(a.left_edge, a.width, b.left_edge, b.width);
  const double up = shared(*a.lower_edge, a.height, *b.lower_edge, b.height);
  return scene.model.tight_plates.value_or(false) && a.velocity == b.velocity && a.ramp == b.ramp &&
         (across >= most * std::min(a.width, b.width) || up >= most * std::min(a.height, b.height));
}

// Of a plate that stands on a wall: it stays there.
inline bool are_one_surface(const Scene& scene, const Plate& plate, Vec2 normal) {
  return scene.model.tight_plates.value_or(false) && dot(plate.velocity, normal) == 0;
}

}  // namespace furrow
