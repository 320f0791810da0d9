// The jump map: what happens between steps.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include "kernel/kernel.h"
#include "physics/link.h"
#include "system/border.h"

namespace furrow {

JumpReport Kernel::jump(double t, State& y) {
  JumpReport report;
  if (watched_) begin_survey();
  if (parts_->tight_plates) keep_faces(t, y);
  if (parts_->friction) {
    return_springs(t, y, report);
  } else if (watched_) {
    rates_.resize(y.size());
    const KeptSlots slots;
    sum_rates(t, y, slots, rates_, [&](const TouchBatch& c, int block) { survey_batch(c, block); });
  }
  if (watched_) finish_survey();
  if (!preparing_) tear_links(t, y, report);
  report.grown = std::exchange(slots_.grown, {});
  report.rates = (parts_->friction || watched_) && report.torn.empty() ? &rates_ : nullptr;
  report.survey = watched_ ? &survey_ : nullptr;
  return report;
}

// Springs return to |xi| <= mu Fn / St; the spring of an open contact becomes 0. The forces computed on the way are
// those of the state after the jump, so the rates of that state come as a by-product. Each spring belongs to one
// contact, so threads may write springs without a lock.
void Kernel::return_springs(double t, State& y, JumpReport& report) {
  ++slots_.now;
  rates_.resize(y.size());
  slots_.kernel = this;
  slots_.state = &y;
  slots_.spring = y.data() + layout_.first_spring;
  slots_.width = layout_.slot_width;
  std::atomic<bool> changed = false;
  std::fill(block_returned_.begin(), block_returned_.end(), 0.0);
  slots_.relaxed = false;
  double& returned = block_returned_[0];
  if (parts_->keeps_ledger) returned = y[layout_.ledger_of(friction_work)];
  std::fill(block_rolled_.begin(), block_rolled_.end(), 0.0);
  double& rolled = block_rolled_[0];
  if (parts_->keeps_ledger) rolled = y[layout_.ledger_of(rolling_work)];
  sum_rates(t, y, slots_, rates_, [&](const TouchBatch& c, int block) {
    const Returned of = parts_->options ? scatter_returned_slots(c, layout_, y) : scatter_returned(c, slots_.spring);
    if (of.changed) changed = true;
    if (of.stirred && (c.kind == disc_disc || c.kind == disc_wall)) slots_.renew(c);
    if (watched_) survey_batch(c, block);
    if (!parts_->keeps_ledger) return;
    if (parts_->rolling_spring) add_rolling_heat(c, *parts_, block_rolled_[block]);
    double& sum = block_returned_[block];
    if (parts_->options) return add_sliding_heat(c, *parts_, sum);
    for (int k = 0; k < c.count; ++k)
      sum += 0.5 * c.shear_stiffness[k] * (c.held[k] * c.held[k] - c.spring[k] * c.spring[k]);
  });
  clear_dummy_slots(y);
  if (slots_.now == 1) {  // the caller's first state may have springs that no contact holds
    for (const int slot : slots_.unused) slots_.relax(slot);
  }
  const auto add = [](double& all, double one) { all += one; };
  furrow::join_blocks(block_returned_, add);
  if (parts_->keeps_ledger) y[layout_.ledger_of(friction_work)] = returned;
  furrow::join_blocks(block_rolled_, add);
  if (parts_->keeps_ledger && parts_->rolling_spring) y[layout_.ledger_of(rolling_work)] = rolled;
  report.springs_changed = changed || slots_.relaxed;
}

void Kernel::keep_faces(double t, const State& y) {
  move_nodes(*parts_, layout_, t, preparing_, y, nodes_);
  const Placement now = placement(t, y);
  search_.update(*parts_, now, threads_);
  HeldFaces kept;
  for (const ContactKind kind : {disc_plate, node_plate}) {
    const Candidates& list = search_.candidates[kind];
    for (int k = 0; k < list.count(); ++k) {
      const ContactId pair{kind, list.a[k], list.b[k]};
      const Face face = face_after(*parts_, search_.faces, pair, now.of(pair), now.t);
      if (face != no_face) kept.push_back({kind, pair.a, pair.b, face});
    }
  }
  search_.faces.swap(kept);
}

int Kernel::slot_of(const ContactId& c) const {
  const Candidates& list = search_.candidates[c.kind];
  const auto [first, last] = std::equal_range(list.a.begin(), list.a.end(), c.a);
  const auto end = list.b.begin() + (last - list.a.begin());
  const auto found = std::find(list.b.begin() + (first - list.a.begin()), end, c.b);
  return found == end ? -1 : list.slot[found - list.b.begin()];
}

int Kernel::slot_followed(const Placement& now, const ContactId& pair) const {
  if (!parts_->flush_plates) return -1;
  const int other = felt_instead(*parts_, search_.faces, pair, now.of(pair), now.t);
  return other < 0 ? -1 : slot_of({pair.kind, pair.a, other});
}

// Adds half as many slots again, and those wanted now. The new slots are taken last, as if they had always been there:
// which contact holds which slot does not depend on when room was made.
void Kernel::grow_slots(int wanting) {
  const int count = wanting + layout_.spring_count / 2;
  const Growth growth{static_cast<std::size_t>(count) * static_cast<std::size_t>(layout_.slot_width),
                      static_cast<std::size_t>(layout_.size() - layout_.first_dummy())};
  growth.apply(*slots_.state);
  growth.apply(rates_);
  slots_.spring = slots_.state->data() + layout_.first_spring;
  slots_.grown = {slots_.grown.count + growth.count, growth.before_end};
  std::vector<int> more(static_cast<std::size_t>(count));
  std::iota(more.rbegin(), more.rend(), layout_.spring_count);
  slots_.unused.insert(slots_.unused.begin(), more.begin(), more.end());
  layout_.spring_count += count;
}

void Kernel::tear_links(double t, State& y, JumpReport& report) {
  if (intact_.empty()) return;
  move_nodes(*parts_, layout_, t, preparing_, y, nodes_);
  if (!links_.any_over(nodes_)) return;
  const LinkArrays& link = parts_->link;
  double released = 0;
  for (const int k : intact_) {
    const double rx = nodes_.x[link.a[k]] - nodes_.x[link.b[k]];
    const double ry = nodes_.y[link.a[k]] - nodes_.y[link.b[k]];
    const double stretch = std::sqrt(rx * rx + ry * ry) - link.rest[k];
    const double force = link.stiffness[k] * stretch;
    if (!link_tears(force, link.strength[k], link.tear_rule(k))) continue;
    report.torn.push_back({t, k, force});
    released += 0.5 * force * stretch;
  }
  if (report.torn.empty()) return;
  // A torn segment of the border no longer touches the disc on it, and the energy of that contact is released.
  if (parts_->keeps_ledger) released += lattice_contact_energy(t, y);
  for (const Tear& tear : report.torn) torn_[tear.link] = 1;
  std::erase_if(intact_, [this](int k) { return torn_[k] != 0; });
  links_.tear(torn_);
  if (parts_->new_faces) find_border();
  if (parts_->keeps_ledger) y[layout_.ledger_of(tear_energy)] += released - lattice_contact_energy(t, y);
}

void Kernel::find_border() {
  std::vector<int> torn;
  for (int k = 0; k < parts_->link.count(); ++k) {
    if (torn_[k] != 0) torn.push_back(k);
  }
  search_.border = touched_segments(*parts_, torn);
  search_.forget();
}

double Kernel::lattice_contact_energy(double t, const State& y) const {
  double energy = 0;
  for_each_contact(t, y, [&](const Contact& c) {
    if (c.id.kind == disc_lattice) energy += stored_energy(*parts_, c);
  });
  return energy;
}

}  // namespace furrow
