// Small scenes for the unit tests, and sums over a right-hand side that a test can do by hand.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "methods/method.h"
#include "run/run.h"
#include "run/system.h"
#include "scene/scene.h"

namespace furrow::test {

// E = 1e6 Pa, nu = 0.25: with itself E* = 533333.3 Pa, G* = 114285.7 Pa.
inline Material elastic_material(const std::string& name = "soft") {
  Material m;
  m.name = name;
  m.young = 1e6;
  m.poisson = 0.25;
  return m;
}

inline Material rigid_material(const std::string& name = "rigid") {
  Material m;
  m.name = name;
  m.rigid = true;
  return m;
}

// One elastic material, no gravity, no damping, no friction.
inline Scene empty_scene() {
  Scene scene;
  scene.model.gravity = 0;
  scene.material = {elastic_material(), rigid_material()};
  return scene;
}

inline Disc disc(Vec2 position, double radius, Vec2 velocity = {}, double spin = 0) {
  Disc d;
  d.position = position;
  d.radius = radius;
  d.velocity = velocity;
  d.spin = spin;
  d.material = "soft";
  return d;
}

inline Wall wall(Vec2 point, Vec2 normal) {
  Wall w;
  w.point = point;
  w.normal = normal;
  w.material = "soft";
  return w;
}

inline Plate plate(Vec2 lower_left, double width, double height, Vec2 velocity = {}) {
  Plate p;
  p.left_edge = lower_left.x;
  p.lower_edge = lower_left.y;
  p.width = width;
  p.height = height;
  p.velocity = velocity;
  p.material = "soft";
  return p;
}

inline LinkKind link_kind(double stiffness, double damping, double strength = infinity) {
  LinkKind k;
  k.stiffness = stiffness;
  k.damping = damping;
  k.strength = strength;
  return k;
}

// Nodes of 2 kg, no links yet.
inline Lattice lattice(Vec2 origin, int rows, int columns, double spacing) {
  Lattice l;
  l.origin = origin;
  l.rows = rows;
  l.columns = columns;
  l.spacing = spacing;
  l.node_mass = 2;
  l.material = "soft";
  return l;
}

inline NodeSetting node_setting(int row, int column, Vec2 displacement, Vec2 velocity = {}, Vec2 force = {}) {
  NodeSetting s;
  s.row = row;
  s.column = column;
  s.displacement = displacement;
  s.velocity = velocity;
  s.force = force;
  return s;
}

// Two nodes 1 m apart on a spring, the first one fixed.
inline Scene single_spring(double stiffness, double damping, double strength = infinity) {
  Scene scene = empty_scene();
  Lattice l = lattice({0, 0}, 1, 2, 1);
  l.fixed_columns = {0};
  l.structural = link_kind(stiffness, damping, strength);
  scene.lattice = {l};
  return scene;
}

inline State rates(const System& system, double t, const State& y) {
  State dydt(y.size(), 0.0);
  system.rhs(t, y, dydt);
  return dydt;
}

inline double mass_of(const System& system, int body) {
  const Parts& parts = system.parts();
  if (body < parts.disc.count()) return parts.disc.mass[body];
  for (int n = 0; n < parts.node.count(); ++n) {
    if (parts.node.body[n] == body) return parts.node.mass[n];
  }
  return std::nan("");
}

// Force on a body (N) as its acceleration tells it, weight included.
inline Vec2 force_on(const System& system, const State& dydt, int body) {
  const double mass = mass_of(system, body);
  return {mass * dydt[system.vx_of(body)], mass * dydt[system.vy_of(body)]};
}

inline double torque_on(const System& system, const State& dydt, int disc_index) {
  return system.parts().disc.inertia[disc_index] * dydt[system.spin_of(disc_index)];
}

// What takes part in all kinds of contact at once: walls, moving plate, a damped lattice that stands on fixed nodes,
// and discs of different sizes thrown at them. Friction, rolling friction and gravity throughout.
inline Scene busy_scene(int discs = 40) {
  Scene scene = empty_scene();
  scene.model.gravity = 9.81;
  scene.model.disc_depth = 0.2;
  scene.material[0].young = 5e6;
  scene.contact.restitution = 0.5;
  scene.contact.friction = 0.4;
  scene.contact.rolling_friction = 0.1;
  scene.wall = {wall({0, 0}, {0, 1}), wall({-0.2, 0}, {1, 0}), wall({0.2, 0}, {-1, 0.1})};
  scene.plate = {plate({-0.16, 0.015}, 0.01, 0.2, {0.8, 0})};
  Lattice l = lattice({0.1, 0.0}, 6, 3, 0.012);
  l.name = "stem";
  l.node_mass = 0.1;
  l.fixed_rows = {0};
  l.gravity = true;
  l.structural = link_kind(2e4, 2, 0.9);
  l.shear = link_kind(1e4, 2, 0.9);
  l.bending = link_kind(5e3, 2);
  scene.lattice = {l};
  std::mt19937_64 random(7);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  for (int k = 0; k < discs; ++k) {
    const double x = -0.13 + 0.022 * (k % 10);
    const int row = k / 10;
    const double y = 0.011 + 0.022 * row;
    const double spin = between(-50, 50), vx = between(-1, 2), vy = between(-1, 1);  // in an order that is stated
    scene.disc.push_back(disc({x, y}, between(0.006, 0.0105), {vx, vy}, spin));
  }
  return scene;
}

// Discs on a segment of a border whose only link is stretched beyond its strength, so that a jump tears it.
inline Scene on_a_segment_that_tears(std::vector<Disc> discs) {
  Scene scene = empty_scene();
  scene.disc = std::move(discs);
  Lattice l = lattice({0, 0}, 1, 2, 1);
  l.structural = link_kind(4, 0, 0.5);
  l.node = {node_setting(0, 1, {0.25, 0})};
  scene.lattice = {l};
  return scene;
}

// A scene at its start, after a first jump: its contacts hold springs, its links have torn.
struct Standing {
  explicit Standing(const Scene& scene) : system(scene), y(system.initial_state()) { system.jump(0, y); }
  System system;
  State y;
};

}  // namespace furrow::test
