// Straight paths between the two states of a step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/geometry.h"
#include "run/step.h"

namespace furrow {

struct Path {
  Vec2 from, to;  // m
};

inline double length(const Path& path) { return std::hypot(path.to.x - path.from.x, path.to.y - path.from.y); }

// When this share of the step is over.
inline Vec2 at(const Path& path, double share) {
  return {path.from.x + share * (path.to.x - path.from.x), path.from.y + share * (path.to.y - path.from.y)};
}

// The share at which it is nearest to the origin.
inline double nearest_share(const Path& path) { return nearest_share({0, 0}, path.from, path.to); }

// The shares of the step at which the origin is on the line through two points that move, at most two; NaN: none.
//   a(s) x b(s) = a x b + s (a x db + da x b) + s^2 da x db
inline std::array<double, 2> crossing_shares(const Path& a, const Path& b) {
  const auto cross = [](Vec2 p, Vec2 q) { return p.x * q.y - p.y * q.x; };
  const Vec2 da = a.to - a.from, db = b.to - b.from;
  const double c = cross(a.from, b.from), l = cross(a.from, db) + cross(da, b.from), q = cross(da, db);
  const double root = std::sqrt(l * l - 4 * q * c), sum = -0.5 * (l + std::copysign(root, l));
  return {sum / q, c / sum};
}

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
