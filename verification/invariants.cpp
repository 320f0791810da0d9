// What must hold of every scene whatever it is, with no number known beforehand: nothing depends on where the observer
// stands, which way he looks, how fast he goes, in what units he measures, in what order he counts.
//
//   turned by Q and carried at V:  r' = Q r + V t
//                                  v' = Q v + V
//                                  spin' = det(Q) spin
//   units of length L, time T, mass M that are powers of two: every number is multiplied by a power of two, which does
//   not change how it is rounded
//
// Source: invariance of Newton's laws; IEEE 754.
#include <algorithm>

#include "run/observe.h"
#include "verification/check.h"
#include "verification/frozen_scenes.h"

namespace furrow::verification {
namespace {

struct Motion {
  double xx = 1, xy = 0, yx = 0, yy = 1;  // Q
  Vec2 velocity{};                        // m/s, V
  double sense() const { return xx * yy - xy * yx; }
  Vec2 turned(Vec2 a) const { return {xx * a.x + xy * a.y, yx * a.x + yy * a.y}; }
  Vec2 carried(Vec2 v) const { return {turned(v).x + velocity.x, turned(v).y + velocity.y}; }
};

constexpr Motion mirror{.xx = -1};
constexpr Motion quarter_turn{.xx = 0, .xy = -1, .yx = 1, .yy = 0};
const Motion part_turn{.xx = std::cos(0.7), .xy = -std::sin(0.7), .yx = std::sin(0.7), .yy = std::cos(0.7)};
constexpr Motion drift{.velocity = {0.5, -0.25}};

// The scene as the other observer sees it. Plates need a Q that carries rectangles into rectangles.
Scene seen(Scene scene, const Motion& m) {
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
Difference difference(const Outcome& base, const Outcome& other, const Motion& m, double t,
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
Difference rounding(const Case& c, const Outcome& base, double travel = 0) {
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

void expect_same(const std::string& name, const Difference& got, const Difference& limit) {
  const char* reason =
      "round-off: two ulps of a place a step, as a random walk, grown as a known error of the start grows";
  expect("greatest difference of place [m], " + name, got.position, 0, absolute(limit.position, reason));
  expect("greatest difference of velocity [m/s], " + name, got.velocity, 0, absolute(limit.velocity, reason));
}

Scene weightless(Scene scene) {
  scene.model.gravity = 0;
  return scene;
}

Scene without_plates(Scene scene) {
  scene.plate.clear();
  return scene;
}

TEST(Invariants, TheScenesAreAtWork) {
  requirement("invariants.at_work");
  for (const Case& c : cases()) {
    const Outcome base = outcome(c, c.scene);
    const Observation at_end = observe(base.system, c.end(), base.y);
    const char* reason = "else the relations below would say little";
    if (c.name == "scenario_1") expect_true(c.name + " tears links", base.torn >= 1, reason);
    if (!c.scene.settle && c.scene.disc.size() == 120) {
      expect_true(c.name + " has more than 150 contacts", at_end.contacts > 150, reason);
      expect_true(c.name + " resists the plate", at_end.plate[0].x < -1, reason);
    }
    expect_true(c.name + " moves", greatest_speed(base.system, base.y) > 1e-3, reason);
  }
}

TEST(Invariants, TurnedScenesTurnTheirMotion) {
  requirement("invariants.turned");
  for (Case c : cases()) {
    c.scene = weightless(c.scene);  // weight has a direction of its own
    const Outcome base = outcome(c, c.scene);
    const Difference limit = rounding(c, base);
    expect_same(c.name + " by a quarter", difference(base, outcome(c, seen(c.scene, quarter_turn)), quarter_turn, 0),
                limit);
    c.scene = without_plates(c.scene);
    const Outcome bare = outcome(c, c.scene);
    expect_same(c.name + " by 0.7 rad, without plates",
                difference(bare, outcome(c, seen(c.scene, part_turn)), part_turn, 0), rounding(c, bare));
  }
}

TEST(Invariants, MirrorImagesMirrorTheirMotionBitForBit) {
  requirement("invariants.mirrored");
  for (Case c : cases()) {
    for (Plate& p : c.scene.plate) {  // edges and travel as binary fractions: left + width must not round
      for (double* edge : {&p.left_edge, &*p.lower_edge, &p.width, &p.height})
        *edge = std::round(*edge * 0x1p20) * 0x1p-20;
      p.velocity = {std::round(p.velocity.x * 0x1p10) * 0x1p-10, std::round(p.velocity.y * 0x1p10) * 0x1p-10};
    }
    const Outcome base = outcome(c, c.scene);
    const Scene image = seen(c.scene, mirror);
    State start = base.system.initial_state();
    const int bodies = base.system.parts().bodies();
    for (int b = 0; b < bodies; ++b) {
      start[base.system.x_of(b)] *= -1;
      start[base.system.vx_of(b)] *= -1;
      if (base.system.has_friction() && b < base.system.parts().disc.count()) start[base.system.spin_of(b)] *= -1;
    }
    const Difference got = difference(base, outcome(c, image, start), mirror, 0);
    const char* reason = "a sign is no rounding, and the mirror image sums in the same order";
    expect("greatest difference of place [m], " + c.name, got.position, 0, exact(reason));
    expect("greatest difference of velocity [m/s], " + c.name, got.velocity, 0, exact(reason));
  }
}

TEST(Invariants, MovingObserversSeeTheSame) {
  requirement("invariants.moving");
  for (Case c : cases()) {
    c.scene.wall.clear();  // a wall and a fixed node stand still for one observer only
    for (Lattice& l : c.scene.lattice) l.fixed_rows.clear(), l.fixed_columns.clear();
    const Outcome base = outcome(c, c.scene);
    const Difference limit = rounding(c, base, drift.velocity.x * c.end());
    expect_same(c.name, difference(base, outcome(c, seen(c.scene, drift)), drift, c.end()), limit);
  }
}

TEST(Invariants, LabelsDoNotMatter) {
  requirement("invariants.labels");
  for (const Case& c : cases()) {
    // Discs and everything else in the opposite order; lattices with their columns counted from the right.
    Scene scene = c.scene;
    std::reverse(scene.disc.begin(), scene.disc.end());
    std::reverse(scene.wall.begin(), scene.wall.end());
    std::reverse(scene.material.begin(), scene.material.end());
    for (Lattice& l : scene.lattice) {
      for (NodeSetting& n : l.node) {
        const int column = l.columns - 1 - n.column;
        n.displacement.x += (l.origin.x + n.column * l.spacing) - (l.origin.x + column * l.spacing);
        n.column = column;
      }
      for (int& column : l.fixed_columns) column = l.columns - 1 - column;
    }
    const Outcome base = outcome(c, c.scene);
    const Outcome other = outcome(c, scene);
    const Parts& parts = base.system.parts();
    std::vector<int> number;
    for (int i = 0; i < parts.disc.count(); ++i) number.push_back(parts.disc.count() - 1 - i);
    for (int n = 0; n < parts.node.count(); ++n) {
      if (parts.node.body[n] < 0) continue;
      const int columns = scene.lattice[parts.node.lattice[n]].columns;
      number.push_back(other.system.parts().node.body[n + columns - 1 - 2 * parts.node.column[n]]);
    }
    expect_same(c.name, difference(base, other, {}, 0, number), rounding(c, base));
  }
}

// In units of which a metre, second and kilogram have L, T and M.
Scene in_units(Scene s, double L, double T, double M) {  // NOLINT(readability-identifier-naming): the usual symbols
  const double speed = L / T, force = M * L / (T * T), pressure = M / (L * T * T);
  const auto scale = [](Vec2& v, double by) { v = {by * v.x, by * v.y}; };
  s.model.gravity *= L / (T * T);
  s.model.disc_depth *= L;
  s.model.rolling_smoothing /= T;
  for (Material& m : s.material) {
    m.density *= M / (L * L * L);
    if (m.young) *m.young *= pressure;
    if (m.shear) *m.shear *= pressure;
  }
  for (Disc& d : s.disc) {
    scale(d.position, L);
    scale(d.velocity, speed);
    d.radius *= L;
    d.spin /= T;
  }
  for (Wall& w : s.wall) scale(w.point, L);
  for (Plate& p : s.plate) {
    for (double* edge : {&p.left_edge, &*p.lower_edge, &p.width, &p.height}) *edge *= L;
    scale(p.velocity, speed);
  }
  for (Lattice& l : s.lattice) {
    scale(l.origin, L);
    l.spacing *= L;
    l.contact_radius *= L;
    l.node_mass *= M;
    for (LinkKind* k : {&l.structural, &l.shear, &l.bending}) {
      k->stiffness *= M / (T * T);
      k->damping *= M / T;
      k->strength *= force;
    }
    for (NodeSetting& n : l.node) {
      scale(n.displacement, L);
      scale(n.velocity, speed);
      scale(n.force, force);
    }
  }
  return s;
}

TEST(Invariants, UnitsOfPowersOfTwoChangeNoBit) {
  requirement("invariants.units");
  constexpr double length = 8, time = 1.0 / 32, mass = 16;
  for (const Case& c : cases()) {
    const Outcome base = outcome(c, c.scene);
    const Outcome other = outcome({c.name, {}, c.step * time, c.steps}, in_units(c.scene, length, time, mass));
    const System& s = base.system;
    double different = 0;
    for (int k = 0; k < static_cast<int>(s.size()); ++k) {
      const bool place = k < s.vx_of(0), speed = k < s.spin_of(0), spin = k < s.first_spring();
      const bool spring = k < s.ledger_of(link_damping);
      const double factor = place    ? length
                            : speed  ? length / time
                            : spin   ? 1 / time
                            : spring ? length
                                     : mass * length * length / (time * time);
      different += other.y[k] == factor * base.y[k] ? 0 : 1;
    }
    expect("numbers of the state with other bits, " + c.name, different, 0,
           exact("places, velocities, spins, springs and energies by their powers of two"));
  }
}

}  // namespace
}  // namespace furrow::verification
