// Scenes and runs as another observer has them: turned, mirrored, carried along; and how far round-off may carry a run.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verification/check.h"
#include "verification/frozen_scenes.h"

namespace furrow::verification::invariants {

struct Motion {
  double xx = 1, xy = 0, yx = 0, yy = 1;  // Q
  Vec2 velocity{};                        // m/s, V
  double sense() const { return xx * yy - xy * yx; }
  Vec2 turned(Vec2 a) const { return {xx * a.x + xy * a.y, yx * a.x + yy * a.y}; }
  Vec2 carried(Vec2 v) const { return {turned(v).x + velocity.x, turned(v).y + velocity.y}; }
};

inline constexpr Motion mirror{.xx = -1};
inline constexpr Motion quarter_turn{.xx = 0, .xy = -1, .yx = 1, .yy = 0};
inline const Motion part_turn{.xx = std::cos(0.7), .xy = -std::sin(0.7), .yx = std::sin(0.7), .yy = std::cos(0.7)};
inline constexpr Motion drift{.velocity = {0.5, -0.25}};

// The scene as the other observer sees it. Plates need a Q that carries rectangles into rectangles.
inline Scene seen(Scene scene, const Motion& m) {
  for (Disc& d : scene.disc) {
    d.position = m.turned(d.position);
    d.velocity = m.carried(d.velocity);
    d.spin *= m.sense();
  }
  for (Wall& w : scene.wall) {
    w.point = m.turned(w.point);
    w.normal = m.turned(w.normal);
  }
  for (Plate& p : scene.plate) {
    const Vec2 a = m.turned({p.left_edge, *p.lower_edge});
    const Vec2 b = m.turned({p.left_edge + p.width, *p.lower_edge + p.height});
    if (m.xx == 0) std::swap(p.width, p.height);
    p.left_edge = std::min(a.x, b.x);
    p.lower_edge = std::min(a.y, b.y);
    p.velocity = m.carried(p.velocity);
  }
  for (Lattice& l : scene.lattice) {
    for (NodeSetting& n : l.node) {
      const Vec2 grid{l.origin.x + n.column * l.spacing, l.origin.y + n.row * l.spacing};
      const Vec2 place = m.turned({grid.x + n.displacement.x, grid.y + n.displacement.y});
      n.displacement = {place.x - grid.x, place.y - grid.y};
      n.velocity = m.carried(n.velocity);
      n.force = m.turned(n.force);
    }
  }
  return scene;
}

struct Difference {
  double position = 0, velocity = 0;  // m, m/s
};

// Of `other`, seen by m at time t, from `base`; body b of `base` is body number[b] of `other`, if that is given.
inline Difference difference(const Outcome& base, const Outcome& other, const Motion& m, double t,
                             std::vector<int> number = {}) {
  const System& s = base.system;
  const int bodies = s.parts().bodies();
  for (int b = static_cast<int>(number.size()); b < bodies; ++b) number.push_back(b);
  Difference most;
  for (int b = 0; b < bodies; ++b) {
    const int o = number[b];
    const Vec2 place = m.turned({base.y[s.x_of(b)], base.y[s.y_of(b)]});
    const Vec2 speed = m.carried({base.y[s.vx_of(b)], base.y[s.vy_of(b)]});
    most.position = std::max({most.position, std::fabs(other.y[s.x_of(o)] - place.x - m.velocity.x * t),
                              std::fabs(other.y[s.y_of(o)] - place.y - m.velocity.y * t)});
    most.velocity =
        std::max({most.velocity, std::fabs(other.y[s.vx_of(o)] - speed.x), std::fabs(other.y[s.vy_of(o)] - speed.y)});
    if (b >= s.parts().disc.count() || !s.has_friction()) continue;
    const double spin = other.y[s.spin_of(o)] - m.sense() * base.y[s.spin_of(b)];
    most.velocity = std::max(most.velocity, std::fabs(spin) * s.parts().disc.radius[b]);
  }
  return most;
}

// How far round-off may carry: two ulps of a place at every step, as a random walk, grown as an error of 1e-10 m of the
// start grows in the same run. `travel`, m: how far everything is carried besides.
inline Difference rounding(const Case& c, const Outcome& base, double travel = 0) {
  State start = base.system.initial_state();
  double size = 0;
  for (std::size_t k = 0; k < base.system.positions(); ++k) {
    size = std::max(size, std::fabs(start[k]));
    start[k] += (k * 7919 % 13 < 6 ? 1e-10 : -1e-10);
  }
  const Outcome off = outcome(c, c.scene, start);
  Difference grown{1, 1};
  for (std::size_t part = 1; part < base.on_the_way.size(); ++part) {
    for (std::size_t k = 0; k < base.system.positions(); ++k) {
      const std::size_t v = k + base.system.positions();
      grown.position = std::max(grown.position, std::fabs(off.on_the_way[part][k] - base.on_the_way[part][k]) / 1e-10);
      grown.velocity = std::max(grown.velocity, std::fabs(off.on_the_way[part][v] - base.on_the_way[part][v]) / 1e-10);
    }
  }
  const double walk = std::exp2(-52) * (size + travel) * std::sqrt(2 * static_cast<double>(c.steps));
  return {walk * grown.position, walk * grown.velocity};
}

inline void expect_same(const std::string& name, const Difference& got, const Difference& limit) {
  const char* reason =
      "round-off: two ulps of a place a step, as a random walk, grown as a known error of the start grows";
  expect("greatest difference of place [m], " + name, got.position, 0, absolute(limit.position, reason));
  expect("greatest difference of velocity [m/s], " + name, got.velocity, 0, absolute(limit.velocity, reason));
}

}  // namespace furrow::verification::invariants
