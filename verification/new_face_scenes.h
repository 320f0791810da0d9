// A lattice of 4 rows of 3 nodes with links so soft that its nodes are free, some of which have torn, and a disc that
// comes to what they leave open.
#pragma once

#include <functional>

#include "verification/coupling_scenes.h"
#include "verification/running.h"

namespace furrow::verification::coupling {

struct Ends {
  int row_a, column_a, row_b, column_b;
};

inline Scene soft_lattice_and_disc(Vec2 position, Vec2 velocity) {
  constexpr LinkKind soft{.stiffness = 1e-9};  // N/m: less than 1e-10 N at half a spacing
  Scene scene = disc_above({.rows = 4, .columns = 3, .structural = soft, .shear = soft}, 0, 0);
  scene.model.new_faces = true;
  scene.disc[0].position = position;
  scene.disc[0].velocity = velocity;
  return scene;
}

// With all links torn for which `gone` holds.
inline System torn_system(const Scene& scene, const std::function<bool(const Ends&)>& gone) {
  System system(scene);
  DiscreteState discrete = system.discrete_state();
  const LinkArrays& link = system.parts().link;
  const NodeArrays& node = system.parts().node;
  for (int k = 0; k < link.count(); ++k) {
    const int a = link.a[k], b = link.b[k];
    if (gone({node.row[a], node.column[a], node.row[b], node.column[b]})) discrete.torn.push_back(k);
  }
  system.restore(discrete);
  return system;
}

inline State run_torn(System& system, double step, double end) {
  State y = system.initial_state();
  run(system, *make_method("rk4"), y, {.start = 0, .end = end, .step = step, .stop = {}},
      [](double, const State&, const JumpReport&) { return true; });
  return y;
}

}  // namespace furrow::verification::coupling
