#include "kernel/kernel.h"

#include <algorithm>

#include "system/floating_point.h"

namespace furrow {
Kernel::Kernel(const std::shared_ptr<const Parts>& parts, const Search& search)
    : Solver(parts, make_layout(*parts)), search_(*parts, search), links_(parts->link) {
  const DefaultFloatingPoint environment;
  const DiscreteState start = initial_discrete_state(*parts_, layout_);
  slots_.unused = start.unused;
  search_.border = start.border;
  tear(start.torn);
  for (int i = 0; i < parts_->disc.count(); ++i) {
    inverse_mass_.push_back(1 / parts_->disc.mass[i]);
    inverse_inertia_.push_back(1 / parts_->disc.inertia[i]);
    gravity_.push_back(parts_->gravity);
  }
  const NodeArrays& node = parts_->node;
  for (int n = 0; n < node.count(); ++n) {
    if (node.body[n] < 0) continue;
    inverse_mass_.push_back(1 / node.mass[n]);
    gravity_.push_back(node.gravity[n]);
  }
  nodes_ = nodes_at_rest(*parts_);
  for (auto* along : {&nodes_.x, &nodes_.y, &nodes_.vx, &nodes_.vy}) along->resize(along->size() + LinkLanes::whole);
  node_fx_.resize(nodes_.x.size());
  node_fy_.resize(nodes_.x.size());
  const auto one_value = [](const auto& all) { return std::equal(all.begin() + 1, all.end(), all.begin()); };
  const DiscArrays& disc = parts_->disc;
  if (disc.count() > 1 && one_value(disc.material)) law_of_pairs_ = parts_->law_of(disc.material[0], disc.material[0]);
  alike_ = law_of_pairs_ >= 0 && one_value(disc.radius) && one_value(disc.mass);
  if (disc.count() > discs_per_block) threads_ = search.threads;
  const int blocks = blocks_of(disc.count());
  block_powers_.resize(static_cast<std::size_t>(blocks));
  block_returned_.resize(static_cast<std::size_t>(blocks));
  block_rolled_.resize(static_cast<std::size_t>(blocks));
  block_seen_.resize(static_cast<std::size_t>(blocks));
  disc_batch_.resize(static_cast<std::size_t>(threads_));
  flat_batch_.touching.fill(1);  // as a rule it holds only contacts that touch
  wall_batch_.kind = disc_wall;
  if (alike_) wall_batch_.radius_a.fill(disc.radius[0]);
  for (TouchBatch& c : disc_batch_) {
    if (!alike_) continue;
    c.law.fill(law_of_pairs_);
    c.radius_a.fill(disc.radius[0]);
    c.radius_b.fill(disc.radius[0]);
    c.reduced_radius.fill(disc.radius[0] * disc.radius[0] / (disc.radius[0] + disc.radius[0]));
    c.reduced_mass.fill(disc.mass[0] * disc.mass[0] / (disc.mass[0] + disc.mass[0]));
  }
}

Placement Kernel::placement(double t, const State& y) const {
  return {preparing_ ? 0 : t, y.data(), y.data() + layout_.bodies, nodes_.x.data(), nodes_.y.data()};
}

namespace {

void fill(Contact& one, const TouchBatch& c, int k) {
  const bool discs = c.kind == disc_disc, lattice = c.kind == disc_lattice;
  one.id = {c.kind, c.a[k], c.b[k]};
  one.law = c.law[k];
  one.slot = c.slot[k];
  one.segment = lattice ? c.segment[k] : -1;
  one.share = lattice ? c.share[k] : 0;
  one.nx = c.nx[k], one.ny = c.ny[k];
  one.arm_a = c.arm_a[k], one.arm_b = discs ? c.arm_b[k] : 0;
  one.vx = c.vx[k], one.vy = c.vy[k];
  one.spin_a = c.spin_a[k], one.spin_b = discs ? c.spin_b[k] : 0;
  const double approach = one.vx * one.nx + one.vy * one.ny;
  one.touch = {c.overlap[k],        approach,          c.slip[k], c.spring[k],         one.spin_a - one.spin_b,
               c.reduced_radius[k], c.reduced_mass[k], c.turn[k], c.rolling_inertia[k]};
  one.force = {c.elastic[k],   c.normal[k],          c.tangential[k],     c.moment[k],
               c.stiffness[k], c.shear_stiffness[k], c.shear_viscosity[k]};
  one.fx = c.fx[k], one.fy = c.fy[k];
  one.torque_a = c.torque_a[k], one.torque_b = discs ? c.torque_b[k] : 0;
}

}  // namespace

Contact Kernel::contact_of(const TouchBatch& c, int k) {
  Contact one;
  fill(one, c, k);
  return one;
}

void Kernel::for_each_contact(double t, const State& y, const Visit& visit) const {
  const std::scoped_lock alone(lock_.mutex);
  Contact one;
  for_each_touch(t, y, [&](const TouchBatch& c) {
    for (int k = 0; k < c.count; ++k) {
      fill(one, c, k);
      visit(one);
    }
  });
}

}  // namespace furrow
