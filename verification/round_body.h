// The two round bodies that the pages on friction try: a disc, 1 m deep, and a sphere.
#pragma once

#include <numbers>
#include <string>

#include "scene/scene.h"

namespace furrow::verification {

struct RoundBody {
  std::string name;
  DiscMass reading;
  double c;                                           // I / (m R^2)
  double kappa() const { return 1 + 1 / c; }          // -, m over the mass of its contact point along the tangent
  double mass(double density, double radius) const {  // kg
    return density * std::numbers::pi * radius * radius * (reading == DiscMass::disc ? 1 : 4 * radius / 3);
  }
};
inline const RoundBody disc{"disc", DiscMass::disc, 0.5};
inline const RoundBody sphere{"sphere", DiscMass::sphere, 0.4};

}  // namespace furrow::verification
