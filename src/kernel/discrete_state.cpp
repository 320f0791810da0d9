// The discrete state of a kernel, read and restored.
#include <algorithm>
#include <stdexcept>

#include "kernel/kernel.h"
#include "system/border.h"

namespace furrow {
DiscreteState Kernel::discrete_state() const {
  DiscreteState d{{}, {}, slots_.unused, slots_.now, preparing_, search_.faces, search_.border};
  for (int link = 0; link < parts_->link.count(); ++link) {
    if (torn(link)) d.torn.push_back(link);
  }
  for (int kind = 0; kind < contact_kinds; ++kind) {
    const Candidates& list = search_.candidates[kind];
    for (int k = 0; k < list.count(); ++k) {
      if (list.slot[k] >= 0) d.held.push_back({kind, list.a[k], list.b[k], list.slot[k], list.near_at[k]});
    }
  }
  return d;
}

void Kernel::restore(const DiscreteState& d) {
  if (!belongs_to(d, *parts_) || (layout_.dummy_slots == 0 && d.spring_count() > 0))
    throw std::invalid_argument("the discrete state is not one of this scene");
  std::array<Candidates, contact_kinds> held;
  for (const DiscreteState::Held& h : d.held) {
    Candidates& list = held[h.kind];
    const int k = list.count();
    list.resize(k + 1);
    list.a[k] = h.a;
    list.b[k] = h.b;
    list.slot[k] = h.slot;
    list.near_at[k] = h.near_at;
  }
  search_.keep_only(held, parts_->disc.count());
  search_.faces = d.faces;
  search_.border = touched_segments(*parts_, d.torn);
  slots_.unused = d.unused;
  slots_.now = d.jumps;
  preparing_ = d.preparing;
  layout_.spring_count = d.spring_count();
  tear(d.torn);
}

void Kernel::tear(const std::vector<int>& links) {
  torn_.assign(static_cast<std::size_t>(parts_->link.count()), 0);
  for (const int link : links) torn_[link] = 1;
  intact_.clear();
  for (int link = 0; link < parts_->link.count(); ++link) {
    if (!torn(link)) intact_.push_back(link);
  }
  links_.tear(torn_);
}

}  // namespace furrow
