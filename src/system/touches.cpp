// Fills blocks of touching contacts with their geometry and runs the contact law over them.
#include <cmath>
#include <type_traits>

#include "system/system.h"

namespace furrow {

// What a contact brings from its list and, its spring, from the state.
void System::take_candidate(TouchBlock& block, int at, const Candidates& list, int candidate, const State& y) const {
  block.candidate[at] = candidate;
  block.a[at] = list.a[candidate];
  block.b[at] = list.b[candidate];
  block.law[at] = list.law[candidate];
  block.reduced_radius[at] = list.reduced_radius[candidate];
  block.reduced_mass[at] = list.reduced_mass[candidate];
  block.spring[at] = list.slot[candidate] < 0 ? 0 : y[springs_ + list.slot[candidate]];
}

// Raw differences of the discs that overlap; `evaluate` makes unit vectors of them, lane by lane.
void System::fill_discs(TouchBlock& block, int& next, const State& y) const {
  const Candidates& list = search_.candidates[disc_disc];
  const double* x = y.data();
  const double* height = y.data() + bodies_;
  const double* radius = parts_.disc.radius.data();
  block.kind = disc_disc;
  int count = 0;
  const int end = list.count();
  int k = next;
  for (; k < end && count < TouchBlock::capacity; ++k) {
    const int a = list.a[k];
    const int b = list.b[k];
    const double dx = x[b] - x[a];
    const double dy = height[b] - height[a];
    const double within = radius[a] + radius[b];
    const double distance2 = dx * dx + dy * dy;
    block.candidate[count] = k;
    block.nx[count] = dx;
    block.ny[count] = dy;
    block.overlap[count] = distance2;
    count += distance2 < within * within ? 1 : 0;  // without a branch: every third candidate or so does not touch
  }
  next = k;
  block.count = count;
  const double* vx = y.data() + 2 * bodies_;
  const double* vy = y.data() + 3 * bodies_;
  for (int i = 0; i < count; ++i) {
    take_candidate(block, i, list, block.candidate[i], y);
    const int a = block.a[i];
    const int b = block.b[i];
    block.vx[i] = vx[a] - vx[b];
    block.vy[i] = vy[a] - vy[b];
    block.radius_a[i] = radius[a];
    block.radius_b[i] = radius[b];
    block.spin_a[i] = friction_ ? y[spin_of(a)] : 0;
    block.spin_b[i] = friction_ ? y[spin_of(b)] : 0;
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
void System::fill_flat(TouchBlock& block, int& next, ContactKind kind, double t, const State& y) const {
  const Candidates& list = search_.candidates[kind];
  const Placement now = placement(t, y);
  const bool disc = of_disc(kind);
  block.kind = kind;
  int count = 0;
  int k = next;
  for (; k < list.count() && count < TouchBlock::capacity; ++k) {
    const int a = list.a[k];
    const int b = list.b[k];
    double other_vx = 0;
    double other_vy = 0;
    double reduced_mass = 0;
    Gap gap{};
    if (kind == disc_lattice) {
      int segment = 0;
      const NearestOnSegment n = nearest_border(now, k, segment);
      const double distance = std::sqrt(n.distance2);
      gap = {distance - parts_.disc.radius[a], n.dx / distance, n.dy / distance};
      if (!(gap.gap < 0)) continue;
      const int i = parts_.border.a[segment];
      const int j = parts_.border.b[segment];
      const double near_i = 1 - n.share;
      const double near_j = n.share;
      other_vx = near_i * nodes_.vx[i] + near_j * nodes_.vx[j];
      other_vy = near_i * nodes_.vy[i] + near_j * nodes_.vy[j];
      const double inverse_i = parts_.node.body[i] < 0 ? 0 : near_i * near_i / parts_.node.mass[i];
      const double inverse_j = parts_.node.body[j] < 0 ? 0 : near_j * near_j / parts_.node.mass[j];
      reduced_mass = 1 / (inverse_mass_[a] + inverse_i + inverse_j);
      block.segment[count] = segment;
      block.share[count] = n.share;
    } else {
      gap = flat_gap(parts_, now, kind, a, b);
      if (kind == disc_plate || kind == node_plate) {
        const PlateAt at = plate_at(b, t);
        other_vx = at.vx;
        other_vy = at.vy;
      }
    }
    if (!(gap.gap < 0)) continue;
    take_candidate(block, count, list, k, y);
    block.nx[count] = gap.nx;
    block.ny[count] = gap.ny;
    block.overlap[count] = -gap.gap;
    block.vx[count] = (disc ? y[vx_of(a)] : nodes_.vx[a]) - other_vx;
    block.vy[count] = (disc ? y[vy_of(a)] : nodes_.vy[a]) - other_vy;
    block.spin_a[count] = disc && friction_ ? y[spin_of(a)] : 0;
    block.spin_b[count] = 0;
    block.radius_a[count] = disc ? parts_.disc.radius[a] : 0;
    block.radius_b[count] = 0;
    if (kind == disc_lattice) block.reduced_mass[count] = reduced_mass;
    ++count;
  }
  next = k;
  block.count = count;
}

// The contact law over a block. Every lane does the same arithmetic, so vector instructions change no bit.
void System::evaluate(TouchBlock& c) const {
  if (c.kind == disc_disc) {
    const double half = 0.5 * lever_;
    for (int k = 0; k < c.count; ++k) {
      const double distance = std::sqrt(c.overlap[k]);
      c.nx[k] = c.nx[k] / distance;
      c.ny[k] = c.ny[k] / distance;
      c.overlap[k] = c.radius_a[k] + c.radius_b[k] - distance;
      c.arm_a[k] = c.radius_a[k] - half * c.overlap[k];
      c.arm_b[k] = c.radius_b[k] - half * c.overlap[k];
    }
  } else {
    const double lever = of_disc(c.kind) ? lever_ : 0;  // a node has no arm
    for (int k = 0; k < c.count; ++k) {
      c.arm_a[k] = c.radius_a[k] - lever * c.overlap[k];
      c.arm_b[k] = 0;
    }
  }
  const auto run = [&](auto rolling, auto law_of) {
    for (int k = 0; k < c.count; ++k) {
      c.approach[k] = c.vx[k] * c.nx[k] + c.vy[k] * c.ny[k];
      c.slip[k] = c.vy[k] * c.nx[k] - c.vx[k] * c.ny[k] + (c.spin_a[k] * c.arm_a[k] + c.spin_b[k] * c.arm_b[k]);
      const Touch touch{c.overlap[k],        c.approach[k],    c.slip[k], c.spring[k], c.spin_a[k] - c.spin_b[k],
                        c.reduced_radius[k], c.reduced_mass[k]};
      const TouchForce f = hertz_mindlin<decltype(rolling)::value>(law_of(k), touch, rolling_smoothing_);
      c.elastic[k] = f.elastic;
      c.normal[k] = f.normal;
      c.tangential[k] = f.tangential;
      c.moment[k] = f.moment;
      c.stiffness[k] = f.stiffness;
      c.shear_stiffness[k] = f.shear_stiffness;
      c.shear_viscosity[k] = f.shear_viscosity;
    }
  };
  const auto with_rolling = [&](auto law_of) {
    if (rolling_) {
      run(std::true_type{}, law_of);
    } else {
      run(std::false_type{}, law_of);
    }
  };
  if (parts_.law.size() == 1) {
    const ContactLaw only = parts_.law.front();
    with_rolling([only](int) { return only; });
  } else {
    with_rolling([this, &c](int k) { return parts_.law[c.law[k]]; });
  }
}

}  // namespace furrow
