// The flow: the rates of the state, summed up from contacts and links.
#include <algorithm>

#include "kernel/kernel.h"

namespace furrow {

void Kernel::flow(double t, const State& y, State& dydt) const {
  const std::scoped_lock alone(lock_.mutex);
  const KeptSlots slots;
  sum_rates(t, y, slots, dydt, [](const TouchBatch& /*batch*/, int /*block*/) {});
}

void Kernel::update_positions(double t, const State& y) const {
  move_nodes(*parts_, layout_, t, preparing_, y, nodes_);
  search_.update(*parts_, placement(t, y), threads_);
  disc_row_.resize(static_cast<std::size_t>(parts_->disc.count()));
  const double* at = y.data();
  in_ranges(threads_, disc_row_.size(), [&](std::size_t first, std::size_t last) {
    interleave(at, at + layout_.bodies, at + 2 * layout_.bodies, at + 3 * layout_.bodies, disc_row_.data(), first,
               last);
  });
}

void Kernel::begin_rates(const State& y, State& dydt) const {
  const auto speeds = static_cast<std::size_t>(2 * layout_.bodies);
  const auto rest = static_cast<std::size_t>(layout_.first_spring);
  copy_in_ranges(threads_, y.data() + speeds, speeds, dydt.data());
  fill_in_ranges(threads_, dydt.data() + rest, dydt.size() - rest, 0.0);
  if (layout_.angles > 0)
    std::copy_n(parts_->friction ? y.data() + layout_.spin_of(0) : parts_->disc.spin.data(), layout_.angles,
                dydt.data() + layout_.angle_of(0));
  disc_load_.resize(static_cast<std::size_t>(parts_->disc.count() + search_.contributions));
  std::fill(block_powers_.begin(), block_powers_.end(), ContactPowers{});
  std::copy(parts_->node.load_x.begin(), parts_->node.load_x.end(), node_fx_.begin());
  std::copy(parts_->node.load_y.begin(), parts_->node.load_y.end(), node_fy_.begin());
}

// Called block by block, just before the pairs of the block, so that its loads are still in the cache.
void Kernel::clear_loads(const DiscBlock& block) const {
  DiscLoad* load = disc_load_.data();
  std::fill(load + block.first_disc, load + block.last_disc, DiscLoad{});
  DiscLoad* contribution = load + parts_->disc.count();
  std::fill(contribution + block.first_contribution, contribution + block.last_contribution, DiscLoad{});
}

void Kernel::add_contacts(const TouchBatch& c, int block, double t, State& dydt) const {
  if (c.kind == disc_disc) {
    add_loads(c, search_.blocks.size() > 1 ? c.load_of_b.data() : c.b, disc_load_.data());
  } else if (of_disc(c.kind)) {
    for (int k = 0; k < c.count; ++k) {
      DiscLoad& sum = disc_load_[c.a[k]];
      sum.fx += c.fx[k];
      sum.fy += c.fy[k];
      sum.torque += c.torque_a[k];
    }
  } else {
    for (int k = 0; k < c.count; ++k) {
      node_fx_[c.a[k]] += c.fx[k];
      node_fy_[c.a[k]] += c.fy[k];
    }
  }
  if (c.kind == disc_lattice) {
    for (int k = 0; k < c.count; ++k) {
      const int i = parts_->border.a[c.segment[k]];
      const int j = parts_->border.b[c.segment[k]];
      node_fx_[i] -= (1 - c.share[k]) * c.fx[k];
      node_fy_[i] -= (1 - c.share[k]) * c.fy[k];
      node_fx_[j] -= c.share[k] * c.fx[k];
      node_fy_[j] -= c.share[k] * c.fy[k];
    }
  }
  if (parts_->friction) scatter_rates(c, dydt);
  if (parts_->keeps_ledger) add_to_ledger(c, block, t, dydt.data() + layout_.ledger_of(0));
}

void Kernel::join_blocks() const {
  const DiscLoad* contribution = disc_load_.data() + parts_->disc.count();
  in_parallel(threads_, static_cast<int>(search_.boundary.size()), [&](int block, int /*thread*/) {
    for (const NeighbourSearch::Contribution& s : search_.boundary[block]) {
      disc_load_[s.disc].fx += contribution[s.number].fx;
      disc_load_[s.disc].fy += contribution[s.number].fy;
      disc_load_[s.disc].torque += contribution[s.number].torque;
    }
  });
  furrow::join_blocks(block_powers_, [](ContactPowers& all, const ContactPowers& one) { all.add(one); });
}

void Kernel::finish_rates(State& dydt) const {
  clear_dummy_slots(dydt);
  double* ax = dydt.data() + 2 * layout_.bodies;
  double* ay = dydt.data() + 3 * layout_.bodies;
  if (parts_->keeps_ledger) {
    double* work = dydt.data() + layout_.ledger_of(0);
    work[contact_viscous] = block_powers_[0].viscous;
    work[friction_work] = block_powers_[0].friction;
    work[rolling_work] = block_powers_[0].rolling;
    work[stiffening] = block_powers_[0].stiffening;
  }
  add_link_forces(parts_->keeps_ledger ? dydt.data() + layout_.ledger_of(0) : nullptr);
  const DiscRates rates{ax,
                        ay,
                        parts_->friction ? dydt.data() + 4 * layout_.bodies : nullptr,
                        inverse_mass_.data(),
                        gravity_.data(),
                        inverse_inertia_.data()};
  in_ranges(threads_, static_cast<std::size_t>(parts_->disc.count()),
            [&](std::size_t first, std::size_t last) { accelerate(disc_load_.data(), rates, first, last); });
  for (int n = 0; n < parts_->node.count(); ++n) {
    const int body = parts_->node.body[n];
    if (body < 0) continue;
    ax[body] = node_fx_[n] * inverse_mass_[body];
    ay[body] = node_fy_[n] * inverse_mass_[body] - gravity_[body];
  }
  for (const int body : parts_->held_x) ax[body] = 0;
  for (const int body : parts_->held_y) ay[body] = 0;
}

void Kernel::add_link_forces(double* work) const {
  links_.add_forces(nodes_, node_fx_.data(), node_fy_.data());
  if (!work) return;
  work[link_damping] = links_.damping();
  for (const int n : parts_->driven) work[plate_work] -= node_fx_[n] * nodes_.vx[n] + node_fy_[n] * nodes_.vy[n];
}

void Kernel::add_to_ledger(const TouchBatch& c, int block, double t, double* work) const {
  if (parts_->options)
    add_powers_with_options(c, *parts_, block_powers_[block]);
  else
    add_powers(c, parts_->friction, block_powers_[block]);
  if (c.kind != disc_plate && c.kind != node_plate) return;
  for (int k = 0; k < c.count; ++k) {
    const PlateAt at = plate_at(parts_->plate[c.b[k]], t, preparing_);
    work[plate_work] += c.force_x(k) * at.vx + c.force_y(k) * at.vy;
  }
}

}  // namespace furrow
