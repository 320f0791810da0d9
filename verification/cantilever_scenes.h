// The beams of own_lattice.h as scenes.
#pragma once

#include "verification/bare_lattice.h"
#include "verification/own_lattice.h"

namespace furrow::verification::cantilever {

inline Scene scene_of(const Beam& beam, double damping) {
  Scene scene = bare_lattice(beam.rows, beam.columns, beam.spacing, beam.mass);
  scene.output.energy = false;
  Lattice& lattice = scene.lattice[0];
  for (int row = 0; row < beam.clamped_rows; ++row) lattice.fixed_rows.push_back(row);
  for (int column = 0; column < beam.clamped_columns; ++column) lattice.fixed_columns.push_back(column);
  lattice.structural = {.stiffness = beam.ks, .damping = beam.ks * damping};
  lattice.shear = {.stiffness = beam.kd, .damping = beam.kd * damping};
  lattice.bending = {.stiffness = beam.kb, .damping = beam.kb * damping};
  lattice.node = {{.row = beam.loaded_row(), .column = beam.loaded_column(), .force = {beam.load_x, beam.load_y}}};
  return scene;
}

// The paper's lattice, ten rows of three, its two lowest rows held, pushed at its upper end; and a short beam.
inline constexpr Beam paper{
    .rows = 10, .columns = 3, .clamped_rows = 2, .ks = 1e4, .kd = 1e4, .kb = 1e4, .load_x = 2, .load_y = 0.5};
inline constexpr Beam beam{.rows = 3, .columns = 6, .clamped_columns = 1, .ks = 1e4, .kd = 5e3, .load_y = -2};

}  // namespace furrow::verification::cantilever
