// The jump map: what happens between steps.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include "kernel/kernel.h"

namespace furrow {

JumpReport Kernel::jump(double t, State& y) {
  JumpReport report;
  if (watched_) begin_survey();
  if (parts_->friction) {
    return_springs(t, y, report);
  } else if (watched_) {
    rates_.resize(y.size());
    add_up(t, y, nullptr, rates_, [&](const TouchBlock& c, int chunk) { survey_block(c, chunk); });
  }
  if (watched_) finish_survey();
  if (!preparing_) tear_links(t, y, report);
  report.grown = std::exchange(slots_.grown, {});
  report.rates = (parts_->friction || watched_) && report.torn.empty() ? &rates_ : nullptr;
  report.survey = watched_ ? &survey_ : nullptr;
  return report;
}

// Springs return to |xi| <= mu Fn / St, that of an opened contact relaxes. The forces that this takes are those of the
// state it leaves, so the rates there come with it. Each spring belongs to one contact, so it may be written at once.
void Kernel::return_springs(double t, State& y, JumpReport& report) {
  ++slots_.now;
  rates_.resize(y.size());
  slots_.kernel = this;
  slots_.state = &y;
  slots_.spring = y.data() + layout_.first_spring;
  std::atomic<bool> changed = false;
  std::fill(chunk_returned_.begin(), chunk_returned_.end(), 0.0);
  slots_.relaxed = false;
  double& returned = chunk_returned_[0];
  if (parts_->keeps_ledger) returned = y[layout_.ledger_of(friction_work)];
  add_up(t, y, &slots_, rates_, [&](const TouchBlock& c, int chunk) {
    if (put_returned(c, slots_.spring)) changed = true;
    if (watched_) survey_block(c, chunk);
    if (!parts_->keeps_ledger) return;
    double& sum = chunk_returned_[chunk];
    for (int k = 0; k < c.count; ++k)
      sum += 0.5 * c.shear_stiffness[k] * (c.held[k] * c.held[k] - c.spring[k] * c.spring[k]);
  });
  empty_spares(y);
  if (slots_.now == 1) {  // the state may come from elsewhere
    for (const int slot : slots_.unused) slots_.relax(slot);
  }
  for (std::size_t k = 1; k < chunk_returned_.size(); ++k) returned += chunk_returned_[k];
  if (parts_->keeps_ledger) y[layout_.ledger_of(friction_work)] = returned;
  report.springs_changed = changed || slots_.relaxed;
}

// Half as much room again, and what is wanted now. The new slots are taken last, as if they had been there always:
// which contact holds which slot does not depend on when there was how much room.
void Kernel::grow_slots(int wanting) {
  const int count = wanting + layout_.spring_count / 2;
  const Growth growth{static_cast<std::size_t>(count),
                      static_cast<std::size_t>(layout_.size() - layout_.first_dummy())};
  growth.apply(*slots_.state);
  growth.apply(rates_);
  slots_.spring = slots_.state->data() + layout_.first_spring;
  slots_.grown = {slots_.grown.count + growth.count, growth.before_end};
  std::vector<int> more(growth.count);
  std::iota(more.rbegin(), more.rend(), layout_.spring_count);
  slots_.unused.insert(slots_.unused.begin(), more.begin(), more.end());
  layout_.spring_count += count;
}

void Kernel::tear_links(double t, State& y, JumpReport& report) {
  if (intact_.empty()) return;
  move_nodes(*parts_, layout_, y, nodes_);
  const LinkArrays& link = parts_->link;
  double released = 0;
  for (const int k : intact_) {
    const double rx = nodes_.x[link.a[k]] - nodes_.x[link.b[k]];
    const double ry = nodes_.y[link.a[k]] - nodes_.y[link.b[k]];
    const double stretch = std::sqrt(rx * rx + ry * ry) - link.rest[k];
    const double force = link.stiffness[k] * stretch;
    if (!((link.in_magnitude[k] != 0 ? std::fabs(force) : force) > link.strength[k])) continue;
    report.torn.push_back({t, k, force});
    released += 0.5 * force * stretch;
  }
  if (report.torn.empty()) return;
  // A torn segment of the border lets go of the disc on it, and of what that contact held.
  if (parts_->keeps_ledger) released += lattice_contact_energy(t, y);
  for (const Tear& tear : report.torn) torn_[tear.link] = 1;
  std::erase_if(intact_, [this](int k) { return torn_[k] != 0; });
  if (parts_->keeps_ledger) y[layout_.ledger_of(tear_energy)] += released - lattice_contact_energy(t, y);
}

double Kernel::lattice_contact_energy(double t, const State& y) const {
  double energy = 0;
  for_each_contact(t, y, [&](const Contact& c) {
    if (c.id.kind == disc_lattice) energy += stored_energy(c);
  });
  return energy;
}

}  // namespace furrow
