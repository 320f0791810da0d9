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

// Whether a spring of the slot is not 0: where the contact does not touch now, it did within the step.
bool Kernel::JumpingSlots::stretched(int slot) const {
  return slot >= 0 && std::any_of(spring + slot * width, spring + (slot + 1) * width, [](double s) { return s != 0; });
}

// Pairs that touched within the step count as near.
void Kernel::JumpingSlots::renew(const TouchBatch& pairs) const {
  Candidates& list = kernel->search_.candidates[pairs.kind];
  const auto first = pairs.slot - list.slot.data();
  for (int k = 0; k < pairs.count; ++k) {
    if (pairs.touching[k] == 0 && (pairs.held[k] != 0 || pairs.turn_held[k] != 0)) list.near_at[first + k] = now;
  }
}

// A near contact takes a slot; one that has not been near for long gives it back.
void Kernel::JumpingSlots::update(Candidates& list, int candidate, bool near) {
  int& slot = list.slot[candidate];
  if (near || stretched(slot)) list.near_at[candidate] = now;
  if (slot_changes(slot, list.near_at[candidate], now) == 0) return;
  if (slot >= 0) {
    unused.push_back(slot);
    slot = -1;
    return;
  }
  slot = unused.back();
  unused.pop_back();
  std::fill_n(spring + slot * width, width, 0.0);
}

// The springs of an open contact are 0.
void Kernel::JumpingSlots::relax(int slot) {
  if (slot < 0) return;
  for (double* number = spring + slot * width; number < spring + (slot + 1) * width; ++number) {
    relaxed = relaxed || *number != 0;
    *number = 0;
  }
}

DiscMotion Kernel::motion(const State& y) const {
  return {disc_row_.data(),
          parts_->friction ? y.data() + layout_.spin_of(0) : nullptr,
          alike_ ? nullptr : parts_->disc.radius.data(),
          parts_->pair_arm_shortening,
          parts_->flat_arm_shortening,
          search_.margin};
}

// Prefetches the discs that the pairs of later batches need: the second discs of those pairs are scattered in memory.
void Kernel::prefetch(const State& y, int first, int last) const {
  constexpr int ahead = 512, a_line = 8;  // discs
  const std::vector<int>& a = search_.candidates[disc_disc].a;
  const int end = std::min(parts_->disc.count(), (a[last - 1] + ahead) & -a_line);
  const bool sums = !disc_load_.empty();  // observers ask for contacts of a kernel that has summed no forces yet
  for (int i = (a[first] + ahead) & -a_line; i < end; i += a_line) {
    if (parts_->friction) __builtin_prefetch(y.data() + layout_.spin_of(i));
    __builtin_prefetch(parts_->disc.radius.data() + i);
    for (int half = 0; half < a_line; half += 2) {
      __builtin_prefetch(disc_row_.data() + i + half);
      if (sums) __builtin_prefetch(disc_load_.data() + i + half, 1);
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
      apply_law(c, model_of_pairs(), {.returning = false, .all_fields = false});
      scatter_rates(c, dydt);
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
  if (parts_->options) return gather_slots(c, *parts_, layout_, y);
  furrow::gather_springs(c, y.data() + layout_.first_spring, dummy_of(block));
}

// In vectors, or contact by contact where some law has options that these do not carry.
void Kernel::apply_law(TouchBatch& c, const ContactModel& model, Evaluation asked) const {
  parts_->options ? evaluate_with_options(c, *parts_, asked.returning) : evaluate(c, model, asked);
}

void Kernel::scatter_rates(const TouchBatch& c, State& dydt) const {
  if (parts_->options) return scatter_spring_rates(c, *parts_, layout_, dydt);
  scatter_to_slots(c, c.slip, dydt.data() + layout_.first_spring);
}

// The nearest point on the candidate's segments; of two equally near points the one on the first segment.
NearestOnSegment Kernel::nearest_border(const Placement& now, int candidate, int& segment) const {
  const Candidates& list = search_.candidates[disc_lattice];
  const int auxiliary = parts_->lattice[list.b[candidate]].auxiliary_points;
  NearestOnSegment best{infinity, 0, 0, 0};
  for (int k = list.first_segment[candidate]; k < list.first_segment[candidate + 1]; ++k) {
    const int s = list.segment[k];
    const int link = parts_->border.link[s];
    const Vec2 disc = now.disc(list.a[candidate]);
    const Vec2 i = now.node(parts_->border.a[s]), j = now.node(parts_->border.b[s]);
    const bool torn = link >= 0 && torn_[link] != 0;
    const NearestOnSegment n = torn ? nearest_end(disc, i, j) : nearest_on_segment(disc, i, j, auxiliary);
    if (n.distance2 < best.distance2) {
      best = n;
      segment = s;
    }
  }
  return best;
}

// The share of the nodes and the reduced mass go into the batch.
Kernel::Facing Kernel::facing_lattice(const Placement& now, int candidate, int n) const {
  TouchBatch& c = flat_batch_;
  const int a = search_.candidates[disc_lattice].a[candidate];
  const NearestOnSegment near = nearest_border(now, candidate, c.segment[n]);
  const int i = parts_->border.a[c.segment[n]];
  const int j = parts_->border.b[c.segment[n]];
  const double near_i = 1 - near.share;
  const double near_j = near.share;
  const double inverse_i = parts_->node.body[i] < 0 ? 0 : near_i * near_i / parts_->node.mass[i];
  const double inverse_j = parts_->node.body[j] < 0 ? 0 : near_j * near_j / parts_->node.mass[j];
  c.reduced_mass[n] = 1 / (inverse_mass_[a] + inverse_i + inverse_j);
  c.share[n] = near.share;
  return {border_gap(near, parts_->disc.radius[a]), near_i * nodes_.vx[i] + near_j * nodes_.vx[j],
          near_i * nodes_.vy[i] + near_j * nodes_.vy[j]};
}

Kernel::Facing Kernel::facing_wall_or_plate(const Placement& now, double t, const ContactId& pair) const {
  const Vec2 a = of_disc(pair.kind) ? now.disc(pair.a) : now.node(pair.a);
  const Gap gap =
      parts_->tight_plates ? held_gap(*parts_, search_.faces, pair, a, now.t) : flat_gap(*parts_, pair, a, now.t);
  if (!of_plate(pair.kind)) return {gap, 0, 0};
  const PlateAt at = plate_at(parts_->plate[pair.b], t, preparing_);
  return {gap, at.vx, at.vy};
}

// Contact n of the batch: a disc or node with a part that does not spin. That part's radius, arm and spin stay 0.
template <ContactKind kind>
void Kernel::put_flat(int candidate, const Facing& other, const State& y, int n) const {
  constexpr bool disc = of_disc(kind);
  const Candidates& list = search_.candidates[kind];
  const int a = list.a[candidate];
  TouchBatch& c = flat_batch_;
  c.own_a[n] = a;
  c.own_b[n] = list.b[candidate];
  c.own_slot[n] = list.slot[candidate];
  c.law[n] = list.law[candidate];
  c.reduced_radius[n] = list.reduced_radius[candidate];
  if (kind != disc_lattice) c.reduced_mass[n] = list.reduced_mass[candidate];
  c.nx[n] = other.gap.nx;
  c.ny[n] = other.gap.ny;
  c.overlap[n] = -other.gap.gap;
  c.vx[n] = (disc ? y[layout_.vx_of(a)] : nodes_.vx[a]) - other.vx;
  c.vy[n] = (disc ? y[layout_.vy_of(a)] : nodes_.vy[a]) - other.vy;
  c.spin_a[n] = disc && parts_->friction ? y[layout_.spin_of(a)] : 0;
  c.radius_a[n] = disc ? parts_->disc.radius[a] : 0;
  c.arm_a[n] = disc ? c.radius_a[n] - parts_->flat_arm_shortening * c.overlap[n] : 0;  // a node has no arm
}

template <ContactKind kind, class Slots>
void Kernel::fill_flat_of(int first, int last, double t, const State& y, Slots& slots) const {
  Candidates& list = search_.candidates[kind];
  if constexpr (Slots::jumping) slots.make_room(list, first, last);
  TouchBatch& c = flat_batch_;
  c.kind = kind;
  c.use_own();
  c.count = 0;
  if (parts_->options) c.touching.fill(1);
  const Placement now = placement(t, y);
  for (int k = first; k < last; ++k) {
    const Facing other = kind == disc_lattice ? facing_lattice(now, k, c.count)
                                              : facing_wall_or_plate(now, t, {kind, list.a[k], list.b[k]});
    if constexpr (Slots::jumping) slots.update(list, k, other.gap.gap < search_.margin);
    if (other.gap.gap < 0) {
      put_flat<kind>(k, other, y, c.count++);
    } else if constexpr (Slots::jumping) {
      if (of_plate(kind) && slot_followed(now, {kind, list.a[k], list.b[k]}) >= 0) continue;
      if (parts_->options && list.slot[k] >= 0) {  // its springs may hold energy
        c.touching[c.count] = 0;
        if (kind == disc_lattice) c.segment[c.count] = 0, c.share[c.count] = 0;  // there may be none
        put_flat<kind>(k, other, y, c.count++);
      } else {
        slots.relax(list.slot[k]);
      }
    }
  }
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
