#include "system/layout.h"

#include <algorithm>

#include "system/order.h"

namespace furrow {
namespace {

// Slots at first. Discs in a plane touch at most six others each, three contacts a disc. In the paper's soft beds
// second neighbours touch too: up to 4.5 a disc were measured at its step (study outlook, discs of 8 mm).
int slots_needed(const Parts& p) {
  const long discs = p.disc.count();
  const long flat = static_cast<long>(p.wall.size() + p.plate.size());
  const long all = discs * (discs - 1) / 2 + discs * (flat + static_cast<long>(p.lattice.size())) + p.free_nodes * flat;
  return static_cast<int>(std::min(all, 5 * discs + p.free_nodes * flat + 16));
}

}  // namespace

Layout make_layout(const Parts& parts) {
  Layout l;
  l.bodies = parts.bodies();
  l.first_spring = 4 * l.bodies + (parts.friction ? parts.disc.count() : 0);
  l.spring_count = parts.friction ? slots_needed(parts) : 0;
  l.dummy_slots = l.spring_count > 0 ? 1 + block_of(parts.disc.count()) : 0;
  l.slot_width = parts.rolling_spring ? 2 : 1;
  l.keeps_ledger = parts.keeps_ledger;
  l.angles = parts.keeps_angles ? parts.disc.count() : 0;
  return l;
}

State initial_state(const Parts& parts, const Layout& l) {
  State y(static_cast<std::size_t>(l.size()), 0.0);
  const DiscArrays& disc = parts.disc;
  for (int i = 0; i < disc.count(); ++i) {
    y[l.x_of(i)] = disc.x[i];
    y[l.y_of(i)] = disc.y[i];
    y[l.vx_of(i)] = disc.vx[i];
    y[l.vy_of(i)] = disc.vy[i];
    if (parts.friction) y[l.spin_of(i)] = disc.spin[i];
  }
  const NodeArrays& node = parts.node;
  for (int n = 0; n < node.count(); ++n) {
    const int body = node.body[n];
    if (body < 0) continue;
    y[l.x_of(body)] = node.x[n];
    y[l.y_of(body)] = node.y[n];
    y[l.vx_of(body)] = node.vx[n];
    y[l.vy_of(body)] = node.vy[n];
  }
  return y;
}

NodeMotion nodes_at_rest(const Parts& parts) {
  const NodeArrays& node = parts.node;
  return {node.x, node.y, std::vector<double>(node.x.size(), 0.0), std::vector<double>(node.x.size(), 0.0)};
}

void move_nodes(const Parts& parts, const Layout& l, double t, bool preparing, const State& y, NodeMotion& nodes) {
  for (int n = 0; n < parts.node.count(); ++n) {
    const int body = parts.node.body[n];
    if (body < 0) continue;
    nodes.x[n] = y[l.x_of(body)];
    nodes.y[n] = y[l.y_of(body)];
    nodes.vx[n] = y[l.vx_of(body)];
    nodes.vy[n] = y[l.vy_of(body)];
  }
  for (const int n : parts.driven) {
    const NodeAt at = held_node_at(parts, n, t, preparing);
    nodes.x[n] = at.x;
    nodes.y[n] = at.y;
    nodes.vx[n] = at.vx;
    nodes.vy[n] = at.vy;
  }
}

}  // namespace furrow
