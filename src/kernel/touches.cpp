// Fills batches of contacts with their geometry and kinematics.
#include <algorithm>
#include <cmath>

#include "kernel/kernel.h"

namespace furrow {

void TouchBatch::fill_last_lanes() {
  if (count % lanes == 0) return;
  std::copy(a, a + count, own_a.begin());
  std::copy(b, b + count, own_b.begin());
  for (int k = count; k % lanes != 0; ++k) {
    own_a[k] = own_a[count - 1];
    own_b[k] = own_b[count - 1];
  }
  a = own_a.data();
  b = own_b.data();
}

void TouchBatch::keep_touching() {
  int n = 0;
  for (int k = 0; k < count; ++k) {
    if (touching[k] == 0) continue;
    own_a[n] = a[k];
    own_b[n] = b[k];
    own_slot[n] = slot[k];
    law[n] = law[k];
    for (auto* field : {&touching, &nx, &ny, &overlap, &vx, &vy, &spin_a, &spin_b, &radius_a, &radius_b, &arm_a, &arm_b,
                        &reduced_radius, &reduced_mass})
      (*field)[n] = (*field)[k];
    ++n;
  }
  count = n;
  use_own();
}

// Makes sure that all of the candidates [first, last) could take a slot.
void Kernel::JumpingSlots::make_room(const Candidates& list, int first, int last) const {
  const auto left = static_cast<std::ptrdiff_t>(unused.size());
  if (left >= last - first) return;
  const auto wanting =
      std::count_if(&list.slot[first], &list.slot[first] + (last - first), [](int s) { return s < 0; });
  if (left < wanting) kernel->grow_slots(static_cast<int>(wanting - left));
}

// A near contact takes a slot; one that has not been near for long gives it back.
void Kernel::JumpingSlots::update(Candidates& list, int candidate, bool near) {
  int& slot = list.slot[candidate];
  if (near) list.near_at[candidate] = now;
  if (slot_changes(slot, list.near_at[candidate], now) == 0) return;
  if (slot >= 0) {
    unused.push_back(slot);
    slot = -1;
    return;
  }
  slot = unused.back();
  unused.pop_back();
  spring[slot] = 0;
}

// The spring of an open contact is 0.
void Kernel::JumpingSlots::relax(int slot) {
  if (slot < 0) return;
  relaxed = relaxed || spring[slot] != 0;
  spring[slot] = 0;
}

DiscMotion Kernel::motion(const State& y) const {
  return {disc_row_.data(), parts_->friction ? y.data() + layout_.spin_of(0) : nullptr,
          alike_ ? nullptr : parts_->disc.radius.data(), parts_->arm_shortening, search_.margin};
}

// Prefetches the discs that the pairs of later batches need: the second discs of those pairs are scattered in memory.
void Kernel::prefetch(const State& y, int first, int last) const {
  constexpr int ahead = 512, a_line = 8;  // discs
  const std::vector<int>& a = search_.candidates[disc_disc].a;
  const int end = std::min(parts_->disc.count(), (a[last - 1] + ahead) & -a_line);
  for (int i = (a[first] + ahead) & -a_line; i < end; i += a_line) {
    if (parts_->friction) __builtin_prefetch(y.data() + layout_.spin_of(i));
    __builtin_prefetch(parts_->disc.radius.data() + i);
    for (int half = 0; half < a_line; half += 2) {
      __builtin_prefetch(disc_row_.data() + i + half);
      __builtin_prefetch(disc_load_.data() + i + half, 1);
    }
  }
}

// Slots are taken and given back in the order of the pairs, after all pairs were evaluated. The spring of a new pair is
// still 0, so its forces are already right and only the rate of its spring is missing.
void Kernel::assign_slots(const State& y, JumpingSlots& slots, State& dydt) const {
  Candidates& list = search_.candidates[disc_disc];
  TouchBatch& c = disc_batch_[0];
  for (std::size_t block = 0; block < search_.blocks.size(); ++block) {
    for (const int first : slots.changing[block]) {
      const int last = std::min(search_.blocks[block].last_pair, first + TouchBatch::capacity);
      slots.make_room(list, first, last);
      for (int k = first; k < last; ++k) slots.update(list, k, false);
      fill_discs(c, y, first, last);
      gather_springs(c, y, static_cast<int>(block));
      evaluate(c, model_of_pairs(), {.returning = false, .all_fields = false});
      scatter_to_slots(c, c.slip, dydt.data() + layout_.first_spring);
    }
  }
}

// Makes the batch of the candidates [first, last), with their constant properties.
void Kernel::point_at(TouchBatch& c, ContactKind kind, int first, int last) const {
  const Candidates& list = search_.candidates[kind];
  c.count = last - first;
  c.a = &list.a[first];
  c.b = &list.b[first];
  c.slot = &list.slot[first];
  c.fill_last_lanes();
  if (kind == disc_disc && alike_) return;
  const auto take = [&](const auto& from, auto& to) { std::copy(&from[first], &from[first] + c.count, &to[0]); };
  take(list.law, c.law);
  take(list.reduced_radius, c.reduced_radius);
  take(list.reduced_mass, c.reduced_mass);
}

// Pairs that do not touch stay in the batch: most pairs of the list do touch, and leaving the others out costs more.
void Kernel::fill_discs(TouchBatch& c, const State& y, int first, int last) const {
  point_at(c, disc_disc, first, last);
  locate_pairs(c, motion(y));
}

template <class Slots>
void Kernel::fill_walls(int first, int last, const State& y, Slots& slots) const {
  Candidates& list = search_.candidates[disc_wall];
  point_at(wall_batch_, disc_wall, first, last);
  locate_walls(wall_batch_, motion(y), parts_->wall.data());
  if constexpr (Slots::jumping) {
    if (!note_near(wall_batch_, &list.near_at[first], slots.now)) return;
    slots.make_room(list, first, last);
    for (int k = first; k < last; ++k) slots.update(list, k, false);
  }
}

void Kernel::gather_springs(TouchBatch& c, const State& y, int block) const {
  if (!parts_->friction) return;
  furrow::gather_springs(c, y.data() + layout_.first_spring, dummy_of(block));
}

// The nearest point on the candidate's segments; of two equally near points the one on the first segment.
NearestOnSegment Kernel::nearest_border(const Placement& now, int candidate, int& segment) const {
  const Candidates& list = search_.candidates[disc_lattice];
  const int auxiliary = parts_->lattice[list.b[candidate]].auxiliary_points;
  NearestOnSegment best{infinity, 0, 0, 0};
  for (int k = list.first_segment[candidate]; k < list.first_segment[candidate + 1]; ++k) {
    const int s = list.segment[k];
    const int link = parts_->border.link[s];
    const NearestOnSegment n =
        nearest_on_segment(now.disc(list.a[candidate]), now.node(parts_->border.a[s]), now.node(parts_->border.b[s]),
                           auxiliary, link >= 0 && torn_[link] != 0);
    if (n.distance2 < best.distance2) {
      best = n;
      segment = s;
    }
  }
  return best;
}

// Contacts of a disc or node with a part that does not spin: wall, plate, lattice. That part's radius, arm and spin
// stay 0 in the batch.
template <ContactKind kind, class Slots>
void Kernel::fill_flat_of(int first, int last, double t, const State& y, Slots& slots) const {
  Candidates& list = search_.candidates[kind];
  if constexpr (Slots::jumping) slots.make_room(list, first, last);
  TouchBatch& c = flat_batch_;
  c.kind = kind;
  c.use_own();
  const Placement now = placement(t, y);
  const bool disc = of_disc(kind);
  const double arm_shortening = disc ? parts_->arm_shortening : 0;  // a node has no arm
  int n = 0;
  for (int k = first; k < last; ++k) {
    const int a = list.a[k];
    const int b = list.b[k];
    double other_vx = 0;
    double other_vy = 0;
    Gap gap{};
    if (kind == disc_lattice) {
      const NearestOnSegment near = nearest_border(now, k, c.segment[n]);
      gap = border_gap(near, parts_->disc.radius[a]);
      const int i = parts_->border.a[c.segment[n]];
      const int j = parts_->border.b[c.segment[n]];
      const double near_i = 1 - near.share;
      const double near_j = near.share;
      other_vx = near_i * nodes_.vx[i] + near_j * nodes_.vx[j];
      other_vy = near_i * nodes_.vy[i] + near_j * nodes_.vy[j];
      const double inverse_i = parts_->node.body[i] < 0 ? 0 : near_i * near_i / parts_->node.mass[i];
      const double inverse_j = parts_->node.body[j] < 0 ? 0 : near_j * near_j / parts_->node.mass[j];
      c.reduced_mass[n] = 1 / (inverse_mass_[a] + inverse_i + inverse_j);
      c.share[n] = near.share;
    } else {
      gap = flat_gap(*parts_, {kind, a, b}, disc ? now.disc(a) : now.node(a), now.t);
      if (kind == disc_plate || kind == node_plate) {
        const PlateAt at = plate_at(parts_->plate[b], t, preparing_);
        other_vx = at.vx;
        other_vy = at.vy;
      }
    }
    if constexpr (Slots::jumping) slots.update(list, k, gap.gap < search_.margin);
    if (!(gap.gap < 0)) {
      if constexpr (Slots::jumping) slots.relax(list.slot[k]);
      continue;
    }
    c.own_a[n] = a;
    c.own_b[n] = b;
    c.own_slot[n] = list.slot[k];
    c.law[n] = list.law[k];
    c.reduced_radius[n] = list.reduced_radius[k];
    if (kind != disc_lattice) c.reduced_mass[n] = list.reduced_mass[k];
    c.nx[n] = gap.nx;
    c.ny[n] = gap.ny;
    c.overlap[n] = -gap.gap;
    c.vx[n] = (disc ? y[layout_.vx_of(a)] : nodes_.vx[a]) - other_vx;
    c.vy[n] = (disc ? y[layout_.vy_of(a)] : nodes_.vy[a]) - other_vy;
    c.spin_a[n] = disc && parts_->friction ? y[layout_.spin_of(a)] : 0;
    c.radius_a[n] = disc ? parts_->disc.radius[a] : 0;
    c.arm_a[n] = c.radius_a[n] - arm_shortening * c.overlap[n];
    ++n;
  }
  c.count = n;
}

template <class Slots>
void Kernel::fill_flat(ContactKind kind, int first, int last, double t, const State& y, Slots& slots) const {
  switch (kind) {
    case disc_plate:
      return fill_flat_of<disc_plate>(first, last, t, y, slots);
    case disc_lattice:
      return fill_flat_of<disc_lattice>(first, last, t, y, slots);
    case node_wall:
      return fill_flat_of<node_wall>(first, last, t, y, slots);
    case node_plate:
      return fill_flat_of<node_plate>(first, last, t, y, slots);
    case disc_disc:
    case disc_wall:
      break;
  }
}

template void Kernel::fill_walls(int, int, const State&, const KeptSlots&) const;
template void Kernel::fill_walls(int, int, const State&, JumpingSlots&) const;
template void Kernel::fill_flat(ContactKind, int, int, double, const State&, const KeptSlots&) const;
template void Kernel::fill_flat(ContactKind, int, int, double, const State&, JumpingSlots&) const;

}  // namespace furrow
