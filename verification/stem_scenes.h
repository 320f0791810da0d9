// A stem that is held at its lower end, and loaded at its upper one.
#pragma once

#include <cmath>
#include <string>

#include "verification/at_rest.h"
#include "verification/bare_lattice.h"

namespace furrow::verification::stem {

inline constexpr double young = 5e8, density = 800, diameter = 0.006;  // Pa, kg/m^3, m
inline const double area = pi * diameter * diameter / 4;               // m^2
inline const double second_moment = std::pow(diameter, 4) * pi / 64;   // m^4
inline const double EA = young * area, EI = young * second_moment;     // N, N m^2

struct Shape {
  int columns = 3;
  double poisson = 1.0 / 3;    // -
  double length = 0.12;        // m
  double strength = infinity;  // Pa
  std::string name() const { return ", " + std::to_string(columns) + " columns, nu = " + std::to_string(poisson); }
};

inline Scene scene_of(const Shape& shape) {
  Scene scene = bare_lattice(1, shape.columns, 1, 1);
  scene.material[0].density = density;
  Lattice& l = scene.lattice[0];
  l.fixed_rows = {0};
  l.stem = Stem{young, shape.poisson, diameter, shape.length, shape.strength};
  return scene;
}

// Forces along x and y on one node of the top row; rows as the length and the width of the cells say.
inline void load(Scene& scene, int column, Vec2 force) {
  const Stem& s = *scene.lattice[0].stem;
  const int rows = 1 + static_cast<int>(std::lround(s.length / s.diameter * (scene.lattice[0].columns - 1)));
  scene.lattice[0].node.push_back({.row = rows - 1, .column = column, .force = force});
}

struct Rest {
  System system;
  State y;
  Vec2 at(int row, int column) const {
    const Parts& parts = system.parts();
    for (int n = 0; n < parts.node.count(); ++n)
      if (parts.node.row[n] == row && parts.node.column[n] == column) {
        const int body = parts.node.body[n];
        return body < 0 ? Vec2{parts.node.x[n], parts.node.y[n]} : Vec2{y[system.x_of(body)], y[system.y_of(body)]};
      }
    return {};
  }
  int rows() const { return system.parts().node.row.back() + 1; }
  int columns() const { return system.parts().node.column.back() + 1; }
  double spacing() const { return system.parts().node.spacing[0]; }
  double turn(int row) const {  // rad, small
    const Vec2 a = at(row, 0), b = at(row, columns() - 1);
    return std::atan2(b.y - a.y, b.x - a.x);
  }
};

inline Rest at_rest(const Scene& scene) {
  const System system(scene);
  return {system, verification::at_rest(system, 0, system.initial_state(), 1e-6 * diameter)};
}

}  // namespace furrow::verification::stem
