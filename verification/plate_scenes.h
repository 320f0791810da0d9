// A plate that meets a lattice, run by the solver. Equations: plate_meets_lattice.cpp.
#pragma once

#include "run/observe.h"
#include "verification/plate_oracle.h"
#include "verification/running.h"

namespace furrow::verification::plate_meets_lattice {

inline Scene meeting(const Meeting& setup) {
  Scene scene;
  scene.model.gravity = 0;
  scene.contact.damping_factor = setup.beta;
  scene.material.push_back({.name = "soil", .young = young, .shear = shear});
  Lattice lattice{
      .rows = setup.rows, .columns = setup.columns, .spacing = spacing, .node_mass = mass, .material = "soil"};
  for (int r = 0; r < setup.fixed_rows; ++r) lattice.fixed_rows.push_back(r);
  if (setup.back_held) lattice.fixed_columns = {setup.columns - 1};
  lattice.contact_radius = contact_radius;
  lattice.structural = lattice.shear =
      lattice.bending = {.stiffness = setup.links * stiffness, .damping = setup.links * damping};
  scene.lattice.push_back(lattice);
  scene.plate.push_back({.left_edge = setup.pressed - 0.01,
                         .lower_edge = setup.lower,
                         .height = 0.1,
                         .velocity = {speed, 0},
                         .material = "soil"});
  return scene;
}

inline Impact run_meeting(const Meeting& setup, const char* method, double step, double end) {
  const Scene scene = meeting(setup);
  const System system(scene);
  Impact out{};
  run_scene(scene, method, step, end, [&](double t, const State& y, const JumpReport&) {
    out.force = -observe(system, t, y).plate[0].x;
    out.peak = std::fmax(out.peak, out.force);
    out.x = y[system.x_of(0)];
    return true;
  });
  return out;
}

}  // namespace furrow::verification::plate_meets_lattice
