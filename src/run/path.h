// Straight paths between the two states of a step.
#pragma once

#include <algorithm>
#include <cmath>

#include "run/step.h"

namespace furrow {

struct Path {
  Vec2 from, to;  // m
};

inline double length(const Path& path) { return std::hypot(path.to.x - path.from.x, path.to.y - path.from.y); }

inline Vec2 body_place(const System& system, const State& y, int body) {
  return {y[system.x_of(body)], y[system.y_of(body)]};
}

inline Path path_of_body(const System& system, const Step& s, int body) {
  return {body_place(system, s.before, body), body_place(system, s.after, body)};
}

// As the middle of the plate sees it.
inline Path path_from_plate(const System& system, const Step& s, int plate, const Path& path) {
  const auto from_middle = [&](double t, Vec2 at) {
    const PlatePart& p = system.parts().plate[plate];
    const PlateAt now = system.plate_at(plate, t);
    return Vec2{at.x - (now.left + 0.5 * p.width), at.y - (now.lower + 0.5 * p.height)};
  };
  return {from_middle(s.t - s.h, path.from), from_middle(s.t, path.to)};
}

// Whether it meets the box |x| <= half_width, |y| <= half_height: clipped axis by axis.
inline bool meets_box(const Path& path, double half_width, double half_height) {
  double enters = 0, leaves = 1;
  const auto clip = [&](double from, double to, double half) {
    const double way = to - from;
    if (way == 0) return std::fabs(from) <= half;
    const double one = (-half - from) / way, other = (half - from) / way;
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
    return true;
  };
  return clip(path.from.x, path.to.x, half_width) && clip(path.from.y, path.to.y, half_height) && enters <= leaves;
}

}  // namespace furrow
