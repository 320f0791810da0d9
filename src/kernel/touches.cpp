// Fills blocks of touching contacts with their geometry.
#include <algorithm>
#include <cmath>

#include "kernel/kernel.h"

namespace furrow {

void TouchBlock::fill_last_lanes() {
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

void TouchBlock::keep_touching() {
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
  look_at_own();
}

// For the candidates [first, last), should all of them want a slot.
void Kernel::Slots::make_room(const Candidates& list, int first, int last) const {
  const auto left = static_cast<std::ptrdiff_t>(unused.size());
  if (left >= last - first) return;
  const auto wanting =
      std::count_if(&list.slot[first], &list.slot[first] + (last - first), [](int s) { return s < 0; });
  if (left < wanting) kernel->grow_slots(static_cast<int>(wanting - left));
}

// A near contact gets a slot, one that has long been apart gives it back.
void Kernel::Slots::see(Candidates& list, int candidate, bool near) {
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

// A contact that is open holds nothing.
void Kernel::Slots::relax(int slot) {
  if (slot < 0) return;
  relaxed = relaxed || spring[slot] != 0;
  spring[slot] = 0;
}

DiscMotion Kernel::motion(const State& y) const {
  return {disc_row_.data(), parts_->friction ? y.data() + layout_.spin_of(0) : nullptr,
          alike_ ? nullptr : parts_->disc.radius.data(), parts_->moment_arm, search_.margin};
}

// Calls for the discs that the pairs after the next blocks need: the second ones of them lie about in memory.
void Kernel::fetch_ahead(const State& y, int first, int last) const {
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

// What takes or gives back slots does so in the order of the pairs, after all of them were seen. A pair that is new
// has come near by distance alone and holds no spring yet, so only the rate of its spring is missing.
void Kernel::hand_out_slots(const State& y, Slots& slots, State& dydt) const {
  Candidates& list = search_.candidates[disc_disc];
  TouchBlock& c = disc_block_[0];
  for (std::size_t chunk = 0; chunk < search_.chunks.size(); ++chunk) {
    for (const int first : slots.changing[chunk]) {
      const int last = std::min(search_.chunks[chunk].last_pair, first + TouchBlock::capacity);
      slots.make_room(list, first, last);
      for (int k = first; k < last; ++k) slots.see(list, k, false);
      fill_discs(c, y, first, last);
      take_springs(c, y, static_cast<int>(chunk));
      evaluate(c, model_of_pairs(), false, false);
      put_by_place(c, c.slip, dydt.data() + layout_.first_spring);
    }
  }
}

// The block of the candidates [first, last), with what never changes of them.
void Kernel::point_at(TouchBlock& c, ContactKind kind, int first, int last) const {
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

// Discs that do not touch stay in the block: with a list so close, leaving them out costs more.
void Kernel::fill_discs(TouchBlock& c, const State& y, int first, int last) const {
  point_at(c, disc_disc, first, last);
  pair_up(c, motion(y));
}

void Kernel::fill_walls(int first, int last, const State& y, Slots* slots) const {
  Candidates& list = search_.candidates[disc_wall];
  point_at(wall_block_, disc_wall, first, last);
  meet_walls(wall_block_, motion(y), parts_->wall.data());
  if (!slots || !note_near(wall_block_, &list.near_at[first], slots->now)) return;
  slots->make_room(list, first, last);
  for (int k = first; k < last; ++k) slots->see(list, k, false);
}

void Kernel::take_springs(TouchBlock& c, const State& y, int chunk) const {
  if (!parts_->friction) return;
  furrow::take_springs(c, y.data() + layout_.first_spring, spare_of(chunk));
}

// Of the candidate's segments the nearest point; of two equally near the first.
NearestOnSegment Kernel::nearest_border(const Placement& now, int candidate, int& segment) const {
  const Candidates& list = search_.candidates[disc_lattice];
  const int auxiliary = parts_->lattice[list.b[candidate]].auxiliary_points;
  NearestOnSegment best{infinity, 0, 0, 0};
  for (int k = list.first_segment[candidate]; k < list.first_segment[candidate + 1]; ++k) {
    const int s = list.segment[k];
    const int link = parts_->border.link[s];
    const NearestOnSegment n =
        segment_distance(*parts_, now, list.a[candidate], s, auxiliary, link >= 0 && torn_[link] != 0);
    if (n.distance2 < best.distance2) {
      best = n;
      segment = s;
    }
  }
  return best;
}

// Other contacts of a disc or node with something that does not spin: wall, plate, lattice. Its radius, arm and spin
// stay 0 in the block.
template <ContactKind kind>
void Kernel::fill_flat_of(int first, int last, double t, const State& y, Slots* slots) const {
  Candidates& list = search_.candidates[kind];
  if (slots) slots->make_room(list, first, last);
  TouchBlock& c = flat_block_;
  c.kind = kind;
  c.look_at_own();
  const Placement now = placement(t, y);
  const bool disc = of_disc(kind);
  const double lever = disc ? parts_->moment_arm : 0;  // a node has no arm
  int n = 0;
  for (int k = first; k < last; ++k) {
    const int a = list.a[k];
    const int b = list.b[k];
    double other_vx = 0;
    double other_vy = 0;
    Gap gap{};
    if (kind == disc_lattice) {
      const NearestOnSegment near = nearest_border(now, k, c.segment[n]);
      const double distance = std::sqrt(near.distance2);
      gap = {distance - parts_->disc.radius[a], near.dx / distance, near.dy / distance};
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
      gap = flat_gap(*parts_, now, kind, a, b);
      if (kind == disc_plate || kind == node_plate) {
        const PlateAt at = plate_at(parts_->plate[b], t, preparing_);
        other_vx = at.vx;
        other_vy = at.vy;
      }
    }
    if (slots) slots->see(list, k, gap.gap < search_.margin);
    if (!(gap.gap < 0)) {
      if (slots) slots->relax(list.slot[k]);
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
    c.arm_a[n] = c.radius_a[n] - lever * c.overlap[n];
    ++n;
  }
  c.count = n;
}

void Kernel::fill_flat(ContactKind kind, int first, int last, double t, const State& y, Slots* slots) const {
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

}  // namespace furrow
