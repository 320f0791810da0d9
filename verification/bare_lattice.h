// A lattice in empty space, without weight: the scene that the pages about springs and lattices start from.
#pragma once

#include "scene/scene.h"

namespace furrow::verification {

// Spacing m, node mass kg. Links, fixed nodes and all else are left to the page.
inline Scene bare_lattice(int rows, int columns, double spacing, double node_mass) {
  Scene scene;
  scene.model.gravity = 0;
  scene.material.push_back({.name = "any", .young = 2e5, .poisson = 0.3});
  Lattice lattice;
  lattice.rows = rows;
  lattice.columns = columns;
  lattice.spacing = spacing;
  lattice.node_mass = node_mass;
  lattice.material = "any";
  scene.lattice.push_back(lattice);
  return scene;
}

}  // namespace furrow::verification
