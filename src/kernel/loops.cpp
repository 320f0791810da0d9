#include "kernel/loops.h"

#include <algorithm>
#include <cmath>

#include "kernel/lanes.h"

namespace furrow {
namespace {

template <int N>
FURROW_WIDE void interleave_lanes(const double* x, const double* y, const double* vx, const double* vy, DiscRow* row,
                                  std::size_t first, std::size_t last) {
  std::size_t i = first;
  for (; i + N <= last; i += N) {
    Row rows[N];
    lanes_to_rows<N>(get<Reals<N>>(x + i), get<Reals<N>>(y + i), get<Reals<N>>(vx + i), get<Reals<N>>(vy + i), rows);
    for (int k = 0; k < N; ++k) put(rows[k], row + i + k);
  }
  for (; i < last; ++i) row[i] = {x[i], y[i], vx[i], vy[i]};
}

template <int N>
FURROW_WIDE void locate_pairs_lanes(TouchBatch& c, const DiscMotion& disc) {
  using Real = Reals<N>;
  const DiscMotion from = disc;
  const double half = from.pair_shortening;
  const int count = c.count;
  const int *a = c.a, *b = c.b;
  for (int k = 0; k < count; k += N, a += N, b += N) {
    Row b_from_a[N];
    for (int i = 0; i < N; ++i) b_from_a[i] = get<Row>(from.row + b[i]) - get<Row>(from.row + a[i]);
    Real dx, dy, vx, vy;
    rows_to_lanes<N>(b_from_a, dx, dy, vx, vy);
    put(-vx, &c.vx[k]);
    put(-vy, &c.vy[k]);
    if (from.spin) {
      put(gather<N>(from.spin, a), &c.spin_a[k]);
      put(gather<N>(from.spin, b), &c.spin_b[k]);
    }
    if (from.radius) {
      put(gather<N>(from.radius, a), &c.radius_a[k]);
      put(gather<N>(from.radius, b), &c.radius_b[k]);
    }
    const auto radius_a = get<Real>(&c.radius_a[k]), radius_b = get<Real>(&c.radius_b[k]);
    const Real within = radius_a + radius_b;
    const Real distance2 = dx * dx + dy * dy;
    const Real distance = square_roots<N>(distance2);
    const auto touching = distance2 < within * within;
    const Real overlap = touching ? within - distance : Real{};
    const Real reach = within + from.margin;
    put(__builtin_convertvector(distance2 < reach * reach, Wholes<N>), &c.near[k]);
    put(touching ? Real{} + 1 : Real{}, &c.touching[k]);
    put(dx / distance, &c.nx[k]);
    put(dy / distance, &c.ny[k]);
    put(overlap, &c.overlap[k]);
    put(radius_a - half * overlap, &c.arm_a[k]);
    put(radius_b - half * overlap, &c.arm_b[k]);
  }
}

template <int N>
FURROW_WIDE void locate_walls_lanes(TouchBatch& c, const DiscMotion& disc, const WallPart* wall) {
  using Real = Reals<N>;
  const DiscMotion from = disc;
  const int count = c.count;
  const int *a = c.a, *b = c.b;
  for (int k = 0; k < count; k += N, a += N, b += N) {
    Row of_disc[N], of_wall[N];
    for (int i = 0; i < N; ++i) of_disc[i] = get<Row>(from.row + a[i]);
    for (int i = 0; i < N; ++i) of_wall[i] = get<Row>(wall + b[i]);
    Real x, y, vx, vy, px, py, nx, ny;
    rows_to_lanes<N>(of_disc, x, y, vx, vy);
    rows_to_lanes<N>(of_wall, px, py, nx, ny);
    if (from.spin) put(gather<N>(from.spin, a), &c.spin_a[k]);
    if (from.radius) put(gather<N>(from.radius, a), &c.radius_a[k]);
    const auto radius = get<Real>(&c.radius_a[k]);
    const Real gap = (x - px) * nx + (y - py) * ny - radius;
    const auto touching = gap < 0.0;
    const Real overlap = touching ? -gap : Real{};
    put(__builtin_convertvector(gap < from.margin, Wholes<N>), &c.near[k]);
    put(touching ? Real{} + 1 : Real{}, &c.touching[k]);
    put(-nx, &c.nx[k]);
    put(-ny, &c.ny[k]);
    put(overlap, &c.overlap[k]);
    put(vx, &c.vx[k]);
    put(vy, &c.vy[k]);
    put(radius - from.flat_shortening * overlap, &c.arm_a[k]);
  }
}

template <int N>
FURROW_WIDE BatchExtremes extremes_lanes(const TouchBatch& c) {
  using Real = Reals<N>;
  const double* radius_b = c.kind == disc_disc ? &c.radius_b[0] : &c.radius_a[0];
  const double count = c.count;
  Real number{}, contacts{}, overlap{}, approach{};
  for (int i = 0; i < N; ++i) number[i] = i;
  for (int k = 0; k < c.count; k += N, number += N) {
    const auto a = get<Real>(&c.radius_a[k]), b = get<Real>(radius_b + k);
    const Real depth = get<Real>(&c.overlap[k]) / (b < a ? b : a);
    const Real speed = get<Real>(&c.vx[k]) * get<Real>(&c.nx[k]) + get<Real>(&c.vy[k]) * get<Real>(&c.ny[k]);
    const Real touching = number < count ? get<Real>(&c.touching[k]) : Real{};  // lanes beyond the last were not filled
    contacts += touching;
    overlap = depth * touching > overlap ? depth : overlap;
    approach = speed * touching > approach ? speed : approach;
  }
  BatchExtremes all;
  for (int i = 0; i < N; ++i) {
    all.contacts += contacts[i];
    all.overlap = std::max(all.overlap, overlap[i]);
    all.approach = std::max(all.approach, approach[i]);
  }
  return all;
}

template <int N>
FURROW_WIDE void gather_springs_lanes(TouchBatch& c, const double* spring, int dummy) {
  const auto none = static_cast<unsigned>(
      dummy);  // -1 becomes huge, and the dummy slot comes after all slots: the smaller number is right
  for (int k = 0; k < c.count; ++k)
    c.slot_or_dummy[k] = static_cast<int>(std::min(static_cast<unsigned>(c.slot[k]), none));
  for (int k = c.count; k < c.whole_lanes(); ++k) c.slot_or_dummy[k] = dummy;
  for (int k = 0; k < c.count; k += N) put(gather<N>(spring, &c.slot_or_dummy[k]), &c.spring[k]);
}

template <int N>
FURROW_WIDE void scatter_to_slots_lanes(const TouchBatch& c, const TouchBatch::Lanes<double>& from, double* by_slot) {
  for (int k = 0; k < c.count; k += N) scatter<N>(get<Reals<N>>(&from[k]), by_slot, &c.slot_or_dummy[k]);
}

template <int N>
FURROW_WIDE Returned scatter_returned_lanes(const TouchBatch& c, double* spring) {
  std::int64_t changed = 0, stirred = 0;
  for (int k = 0; k < c.count; ++k) {
    const std::int64_t other = c.spring[k] != c.held[k] ? 1 : 0;
    changed += other;
    stirred += c.touching[k] == 0 ? other : 0;
  }
  scatter_to_slots_lanes<N>(c, c.spring, spring);
  return {changed != 0, stirred != 0};
}

FURROW_WIDE bool note_near_lanes(const TouchBatch& c, std::uint32_t* near_at, std::uint32_t now) {
  const int* slot = c.slot;
  std::uint32_t changes = 0;
  for (int k = 0; k < c.count; ++k) {
    near_at[k] = c.near[k] != 0 ? now : near_at[k];
    changes |= slot_changes(slot[k], near_at[k], now);
  }
  return changes != 0;
}

// The pairs of one disc as `a` follow each other: its sum stays in a register.
template <int N>
FURROW_WIDE void add_loads_lanes(const TouchBatch& c, const int* load_of_b, DiscLoad* sum) {
  const Row sign{-1, -1, 1, 1};
  const int* own = c.a;
  const int count = c.count;
  Row on_a{};
  int a = -1;
  const auto add = [&](int k, const Row& load) {
    if (own[k] != a) {
      if (a >= 0) put(on_a, sum + a);
      a = own[k];
      on_a = get<Row>(sum + a);
    }
    on_a += load;
    DiscLoad* on_b = sum + load_of_b[k];
    put(get<Row>(on_b) + sign * __builtin_shufflevector(load, load, 0, 1, 3, 3), on_b);
  };
  int k = 0;
  for (; k + N <= count; k += N) {
    Row load[N];
    lanes_to_rows<N>(get<Reals<N>>(&c.fx[k]), get<Reals<N>>(&c.fy[k]), get<Reals<N>>(&c.torque_a[k]),
                     get<Reals<N>>(&c.torque_b[k]), load);
    for (int i = 0; i < N; ++i) add(k + i, load[i]);
  }
  for (; k < count; ++k) add(k, Row{c.fx[k], c.fy[k], c.torque_a[k], c.torque_b[k]});
  if (a >= 0) put(on_a, sum + a);
}

template <class Real>
FURROW_WIDE void accelerate_from(std::size_t i, const Real& fx, const Real& fy, const Real& torque,
                                 const DiscRates& rates) {
  const auto inverse_mass = get<Real>(rates.inverse_mass + i);
  put(fx * inverse_mass, rates.ax + i);
  put(fy * inverse_mass - get<Real>(rates.gravity + i), rates.ay + i);
  if (rates.turning) put(torque * get<Real>(rates.inverse_inertia + i), rates.turning + i);
}

template <int N>
FURROW_WIDE void accelerate_lanes(const DiscLoad* load, const DiscRates& rates, std::size_t first, std::size_t last) {
  std::size_t i = first;
  for (; i + N <= last; i += N) {
    Row row[N];
    for (int k = 0; k < N; ++k) row[k] = get<Row>(load + i + k);
    Reals<N> fx, fy, torque, unused;
    rows_to_lanes<N>(row, fx, fy, torque, unused);
    accelerate_from(i, fx, fy, torque, rates);
  }
  for (; i < last; ++i) accelerate_from(i, load[i].fx, load[i].fy, load[i].torque, rates);
}

}  // namespace

FURROW_WIDTHS_OF(void, interleave,
                 (const double* x, const double* y, const double* vx, const double* vy, DiscRow* row, std::size_t first,
                  std::size_t last),
                 (x, y, vx, vy, row, first, last))
FURROW_WIDTHS_OF(void, locate_pairs, (TouchBatch & c, const DiscMotion& disc), (c, disc))
FURROW_WIDTHS_OF(void, locate_walls, (TouchBatch & c, const DiscMotion& disc, const WallPart* wall), (c, disc, wall))
FURROW_WIDTHS_OF(BatchExtremes, extremes, (const TouchBatch& c), (c))
FURROW_WIDTHS_OF(void, gather_springs, (TouchBatch & c, const double* spring, int dummy), (c, spring, dummy))
FURROW_WIDTHS_OF(void, scatter_to_slots, (const TouchBatch& c, const TouchBatch::Lanes<double>& from, double* by_slot),
                 (c, from, by_slot))
FURROW_WIDTHS_OF(Returned, scatter_returned, (const TouchBatch& c, double* spring), (c, spring))
FURROW_WIDTHS(bool, note_near, (const TouchBatch& c, std::uint32_t* near_at, std::uint32_t now), (c, near_at, now))
FURROW_WIDTHS_OF(void, add_loads, (const TouchBatch& c, const int* load_of_b, DiscLoad* sum), (c, load_of_b, sum))
FURROW_WIDTHS_OF(void, accelerate, (const DiscLoad* load, const DiscRates& rates, std::size_t first, std::size_t last),
                 (load, rates, first, last))

}  // namespace furrow
