// The state at t = 0 as a scene of its own.
#include <algorithm>

#include "export/export.h"

namespace furrow {
namespace {

NodeSetting& setting_of(Lattice& lattice, int row, int column) {
  for (NodeSetting& one : lattice.node) {
    if (one.row == row && one.column == column) return one;
  }
  NodeSetting fresh;
  fresh.row = row;
  fresh.column = column;
  lattice.node.push_back(fresh);
  return lattice.node.back();
}

void move_discs(const Prepared& prepared, Scene& scene) {
  const System& system = prepared.system;
  for (int i = 0; i < system.parts().disc.count(); ++i) {
    Disc& disc = scene.disc[static_cast<std::size_t>(system.parts().disc.number[i])];
    disc.position = {prepared.y[system.x_of(i)], prepared.y[system.y_of(i)]};
    disc.velocity = {prepared.y[system.vx_of(i)], prepared.y[system.vy_of(i)]};
    disc.spin = system.spin(prepared.y, i);
  }
}

// Lengths at rest are those of the grid, wherever the nodes are.
void move_nodes(const Prepared& prepared, Scene& scene) {
  const NodeArrays& node = prepared.system.parts().node;
  const NodeMotion now = prepared.system.nodes(0, prepared.y);
  for (int k = 0; k < node.count(); ++k) {
    if (node.body[k] < 0) continue;
    Lattice& lattice = scene.lattice[static_cast<std::size_t>(node.lattice[k])];
    NodeSetting& one = setting_of(lattice, node.row[k], node.column[k]);
    one.displacement.x += now.x[k] - node.x[k];
    one.displacement.y += now.y[k] - node.y[k];
    one.velocity = {now.vx[k], now.vy[k]};
  }
}

}  // namespace

Scene started_scene(const Prepared& prepared) {
  Scene scene = prepared.scene;
  move_discs(prepared, scene);
  if (scene.settle) move_nodes(prepared, scene);
  scene.settle.reset();
  return scene;
}

}  // namespace furrow
