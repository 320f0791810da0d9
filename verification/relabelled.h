// Scenes written in another way, which changes nothing of what happens: other order, other units.
#pragma once

#include <algorithm>

#include "verification/frozen_scenes.h"

namespace furrow::verification::invariants {

// Discs and everything else in the opposite order; lattices with their columns counted from the right.
inline Scene relabelled(Scene scene) {
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
  return scene;
}

// In units of which a metre, second and kilogram have L, T and M.
inline Scene in_units(Scene s, double L, double T,
                      double M) {  // NOLINT(readability-identifier-naming): the usual symbols
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

}  // namespace furrow::verification::invariants
