// The beams of own_lattice.h as scenes.
#pragma once

#include "run/system.h"
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

// An isotropic lattice, nu = 1/3, of height 1 m and `slenderness` m long, pushed across at its end (N): ks = 2 kd (N/m),
// no skip-one springs.
inline Beam isotropic(int cells, int slenderness, double kd, double load_y) {
  return {.rows = cells + 1,
          .columns = slenderness * cells + 1,
          .clamped_columns = 1,
          .ks = 2 * kd,
          .kd = kd,
          .load_y = load_y,
          .spacing = 1.0 / cells};
}

// m, Timoshenko's deflection of its end: E = 8 kd/3, I = 1/12, kappa G = 5/6 kd.
inline double timoshenko(int slenderness, double kd, double load_y) {
  const double length = slenderness;
  return load_y * (length * length * length / (3 * 8 * kd / 3 / 12) + length / (5.0 / 6 * kd));
}

// Displacements of the solver's own equilibrium: from `rest`, that of the assembly, which is near, one Newton step with
// the solver's forces there.
inline Vector solver_rest(const Beam& b, const Assembly& own, const Vector& rest) {
  const System system(scene_of(b, 0));
  State y = system.initial_state();
  for (int i = 0; i < rest.size() / 2; ++i) {
    y[system.x_of(i)] += rest[2 * i];
    y[system.y_of(i)] += rest[2 * i + 1];
  }
  State rates(y.size());
  system.rhs(0, y, rates);
  Vector left(rest.size());  // N
  for (int i = 0; i < rest.size() / 2; ++i)
    left.segment<2>(2 * i) << b.mass * rates[system.vx_of(i)], b.mass * rates[system.vy_of(i)];
  return rest + solved(own.stiffness(rest), left);
}

}  // namespace furrow::verification::cantilever
