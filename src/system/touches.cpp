// Fills blocks of touching contacts with their geometry.
#include <cmath>

#include "system/system.h"

namespace furrow {

void System::Slots::take_changed(Candidates& list) {
  for (int i = 0; i < nearness.changed; ++i) take_or_give_back(list, nearness.candidate[i]);
}

void System::Slots::take_or_give_back(Candidates& list, int candidate) {
  int& slot = list.slot[candidate];
  if (slot >= 0) {
    unused.push_back(slot);
    slot = -1;
    return;
  }
  if (unused.empty()) throw Divergence("more contacts than a plane holds: no tangential spring is left");
  slot = unused.back();
  unused.pop_back();
}

// A near contact gets a slot, one that has long been apart gives it back.
void System::Slots::see(Candidates& list, int candidate, bool near) {
  const bool held = list.slot[candidate] >= 0;
  if (near) list.near_at[candidate] = nearness.now;
  if (near ? !held : held && nearness.now - list.near_at[candidate] > quiet_jumps) take_or_give_back(list, candidate);
}

void System::pack_discs(const State& y) const {
  for (int i = 0; i < parts_.disc.count(); ++i) {
    packed_[i] = {-y[x_of(i)],          -y[y_of(i)], y[vx_of(i)], y[vy_of(i)], friction_ ? y[spin_of(i)] : 0,
                  parts_.disc.radius[i]};
  }
}

// The block of those of the candidates [first, last) that touch.
void System::fill(ContactKind kind, int first, int last, double t, const State& y, Slots* slots) const {
  Candidates& list = search_.candidates[kind];
  TouchBlock& c = block_;
  c.kind = kind;
  if (kind == disc_disc) {
    kernel_->narrow(c, list, first, last, packed_.data(), slots ? &slots->nearness : nullptr);
    if (slots) slots->take_changed(list);
  } else {
    fill_flat(kind, first, last, t, y, slots);
  }
  const double* spring = y.data() + springs_;
  for (int i = 0; i < c.count; ++i) {
    const int k = c.candidate[i];
    const int slot = list.slot[k];
    c.law[i] = list.law[k];
    c.slot[i] = slot;
    c.reduced_radius[i] = list.reduced_radius[k];
    if (kind != disc_lattice) c.reduced_mass[i] = list.reduced_mass[k];
    c.spring[i] = slot < 0 ? 0 : spring[slot];
  }
}

// Of the candidate's segments the nearest point; of two equally near the first.
NearestOnSegment System::nearest_border(const Placement& now, int candidate, int& segment) const {
  const Candidates& list = search_.candidates[disc_lattice];
  const int auxiliary = parts_.lattice[list.b[candidate]].auxiliary_points;
  NearestOnSegment best{infinity, 0, 0, 0};
  for (int k = list.first_segment[candidate]; k < list.first_segment[candidate + 1]; ++k) {
    const int s = list.segment[k];
    const int link = parts_.border.link[s];
    const NearestOnSegment n =
        segment_distance(parts_, now, list.a[candidate], s, auxiliary, link >= 0 && torn_[link] != 0);
    if (n.distance2 < best.distance2) {
      best = n;
      segment = s;
    }
  }
  return best;
}

// Contacts of a disc or node with something that does not spin: wall, plate, lattice.
void System::fill_flat(ContactKind kind, int first, int last, double t, const State& y, Slots* slots) const {
  Candidates& list = search_.candidates[kind];
  TouchBlock& c = block_;
  const Placement now = placement(t, y);
  const bool disc = of_disc(kind);
  const double lever = disc ? lever_ : 0;  // a node has no arm
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
      gap = {distance - parts_.disc.radius[a], near.dx / distance, near.dy / distance};
      const int i = parts_.border.a[c.segment[n]];
      const int j = parts_.border.b[c.segment[n]];
      const double near_i = 1 - near.share;
      const double near_j = near.share;
      other_vx = near_i * nodes_.vx[i] + near_j * nodes_.vx[j];
      other_vy = near_i * nodes_.vy[i] + near_j * nodes_.vy[j];
      const double inverse_i = parts_.node.body[i] < 0 ? 0 : near_i * near_i / parts_.node.mass[i];
      const double inverse_j = parts_.node.body[j] < 0 ? 0 : near_j * near_j / parts_.node.mass[j];
      c.reduced_mass[n] = 1 / (inverse_mass_[a] + inverse_i + inverse_j);
      c.share[n] = near.share;
    } else {
      gap = flat_gap(parts_, now, kind, a, b);
      if (kind == disc_plate || kind == node_plate) {
        const PlateAt at = plate_at(b, t);
        other_vx = at.vx;
        other_vy = at.vy;
      }
    }
    if (slots) slots->see(list, k, gap.gap < search_.margin);
    if (!(gap.gap < 0)) continue;
    c.candidate[n] = k;
    c.a[n] = a;
    c.b[n] = b;
    c.nx[n] = gap.nx;
    c.ny[n] = gap.ny;
    c.overlap[n] = -gap.gap;
    c.vx[n] = (disc ? y[vx_of(a)] : nodes_.vx[a]) - other_vx;
    c.vy[n] = (disc ? y[vy_of(a)] : nodes_.vy[a]) - other_vy;
    c.spin_a[n] = disc && friction_ ? y[spin_of(a)] : 0;
    c.spin_b[n] = 0;
    c.radius_a[n] = disc ? parts_.disc.radius[a] : 0;
    c.radius_b[n] = 0;
    c.arm_a[n] = c.radius_a[n] - lever * c.overlap[n];
    c.arm_b[n] = 0;
    ++n;
  }
  c.count = n;
}

}  // namespace furrow
