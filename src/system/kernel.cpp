#include "system/kernel.h"

#include <cmath>
#include <cstring>

#include "methods/wide.h"

namespace furrow {
namespace {

FURROW_WIDE int whole_lanes(int count) { return (count + TouchBlock::lanes - 1) & -TouchBlock::lanes; }

using Four [[gnu::vector_size(32)]] = double;

// One lane after the other: that takes less than the gather instructions of the processors at hand.
template <bool Spins, bool Radii>
void pair_up_loop(TouchBlock& c, const DiscMotion& disc) {
  const DiscMotion from = disc;
  const int count = c.count;
  int before = -1;
  double x = 0, y = 0, vx = 0, vy = 0, spin = 0, radius = 0;
  for (int k = 0; k < count; ++k) {
    const int a = c.a[k];
    const int b = c.b[k];
    if (a != before) {
      x = from.x[a];
      y = from.y[a];
      vx = from.vx[a];
      vy = from.vy[a];
      if constexpr (Spins) spin = from.spin[a];
      if constexpr (Radii) radius = from.radius[a];
      before = a;
    }
    c.dx[k] = from.x[b] - x;
    c.dy[k] = from.y[b] - y;
    c.vx[k] = vx - from.vx[b];
    c.vy[k] = vy - from.vy[b];
    if constexpr (Spins) {
      c.spin_a[k] = spin;
      c.spin_b[k] = from.spin[b];
    }
    if constexpr (Radii) {
      c.radius_a[k] = radius;
      c.radius_b[k] = from.radius[b];
    }
  }
}

FURROW_WIDE bool note_near_lanes(const TouchBlock& c, std::uint32_t* near_at, const Nearness& nearness) {
  const double margin = nearness.margin;
  const std::uint32_t now = nearness.now;
  TouchBlock::Lanes<std::uint32_t> near;
  for (int k = 0; k < c.count; ++k) {
    const double reach = c.radius_a[k] + c.radius_b[k] + margin;
    near[k] = c.dx[k] * c.dx[k] + c.dy[k] * c.dy[k] < reach * reach ? 1 : 0;
  }
  std::uint32_t changes = 0;
  for (int k = 0; k < c.count; ++k) {
    near_at[k] = near[k] != 0 ? now : near_at[k];
    changes |= slot_changes(c.slot[k], near_at[k], now);
  }
  return changes != 0;
}

// What the law needs of one contact, all kinds alike.
struct Lane {
  double nx, ny, overlap, vx, vy, spin_a, spin_b, radius_a, radius_b, arm_a, arm_b;
  bool touching;
};

FURROW_WIDE Lane lane_of_discs(const TouchBlock& c, int k, double lever) {
  const double half = 0.5 * lever;
  const double distance2 = c.dx[k] * c.dx[k] + c.dy[k] * c.dy[k];
  const double within = c.radius_a[k] + c.radius_b[k];
  const double distance = std::sqrt(distance2);
  const bool touching = distance2 < within * within;
  const double overlap = touching ? within - distance : 0;
  return {c.dx[k] / distance,
          c.dy[k] / distance,
          overlap,
          c.vx[k],
          c.vy[k],
          c.spin_a[k],
          c.spin_b[k],
          c.radius_a[k],
          c.radius_b[k],
          c.radius_a[k] - half * overlap,
          c.radius_b[k] - half * overlap,
          touching};
}

FURROW_WIDE Lane lane_as_filled(const TouchBlock& c, int k) {
  return {c.nx[k],     c.ny[k],       c.overlap[k],  c.vx[k],    c.vy[k],    c.spin_a[k],
          c.spin_b[k], c.radius_a[k], c.radius_b[k], c.arm_a[k], c.arm_b[k], true};
}

// What only an onlooker and the ledger need.
FURROW_WIDE void store_details(TouchBlock& c, int k, const Lane& lane, const TouchForce& f) {
  c.touching[k] = lane.touching ? 1 : 0;
  c.nx[k] = lane.nx;
  c.ny[k] = lane.ny;
  c.overlap[k] = lane.overlap;
  c.vx[k] = lane.vx;
  c.vy[k] = lane.vy;
  c.radius_a[k] = lane.radius_a;
  c.radius_b[k] = lane.radius_b;
  c.spin_a[k] = lane.spin_a;
  c.spin_b[k] = lane.spin_b;
  c.arm_a[k] = lane.arm_a;
  c.arm_b[k] = lane.arm_b;
  c.elastic[k] = f.elastic;
  c.normal[k] = f.normal;
  c.tangential[k] = f.tangential;
  c.moment[k] = f.moment;
  c.stiffness[k] = f.stiffness;
  c.shear_stiffness[k] = f.shear_stiffness;
  c.shear_viscosity[k] = f.shear_viscosity;
}

template <bool Discs, bool OneLaw, bool Rolling, bool Returning, bool Details>
FURROW_WIDE void law_lanes(TouchBlock& c, const ContactModel& model) {
  const ContactLaw* laws = model.law;
  const ContactLaw only = *laws;
  const double rolling_smoothing = model.rolling_smoothing;
  const double lever = model.lever;
  for (int k = 0; k < whole_lanes(c.count); ++k) {
    const ContactLaw& law = OneLaw ? only : laws[c.law[k]];
    const Lane lane = Discs ? lane_of_discs(c, k, lever) : lane_as_filled(c, k);
    const double approach = lane.vx * lane.nx + lane.vy * lane.ny;
    const double slip = lane.vy * lane.nx - lane.vx * lane.ny + (lane.spin_a * lane.arm_a + lane.spin_b * lane.arm_b);
    Touch touch{lane.overlap,        approach,         slip, c.spring[k], lane.spin_a - lane.spin_b,
                c.reduced_radius[k], c.reduced_mass[k]};
    TouchForce f = hertz_mindlin<Rolling>(law, touch, rolling_smoothing);
    if constexpr (Returning) {
      touch.spring = lane.touching ? returned_spring(law, f, touch.spring) : 0;
      c.spring[k] = touch.spring;
      f = hertz_mindlin<Rolling>(law, touch, rolling_smoothing);
    }
    if constexpr (Details) {
      store_details(c, k, lane, f);
      c.approach[k] = approach;
    }
    c.slip[k] = lane.touching ? slip : 0;
    c.fx[k] = -f.normal * lane.nx - f.tangential * lane.ny;
    c.fy[k] = -f.normal * lane.ny + f.tangential * lane.nx;
    c.torque_a[k] = lane.arm_a * f.tangential + f.moment;
    c.torque_b[k] = lane.arm_b * f.tangential - f.moment;
  }
}

// From what is known at run time to a loop without questions.
template <bool... Known, class... Asked>
FURROW_WIDE void choose_loop(TouchBlock& c, const ContactModel& model, bool first, Asked... asked) {
  if constexpr (sizeof...(asked) == 0) {
    first ? law_lanes<Known..., true>(c, model) : law_lanes<Known..., false>(c, model);
  } else {
    first ? choose_loop<Known..., true>(c, model, asked...) : choose_loop<Known..., false>(c, model, asked...);
  }
}

FURROW_WIDE void evaluate_lanes(TouchBlock& c, const ContactModel& model, bool returning, bool details) {
  choose_loop<>(c, model, c.kind == disc_disc, model.one_law, model.rolling, returning, details);
}

// The pairs of one disc as `a` follow each other: its sum stays in a register.
FURROW_WIDE void add_loads_lanes(const TouchBlock& c, const int* load_of_b, DiscLoad* sum) {
  const Four sign{-1, -1, 1, 1};
  Four on_a{};
  int a = -1;
  for (int k = 0; k < c.count; ++k) {
    if (c.a[k] != a) {
      if (a >= 0) std::memcpy(&sum[a], &on_a, sizeof on_a);
      a = c.a[k];
      std::memcpy(&on_a, &sum[a], sizeof on_a);
    }
    const Four load{c.fx[k], c.fy[k], c.torque_a[k], c.torque_b[k]};
    on_a += load;
    Four sum_b;
    std::memcpy(&sum_b, &sum[load_of_b[k]], sizeof sum_b);
    sum_b += sign * __builtin_shufflevector(load, load, 0, 1, 3, 3);
    std::memcpy(&sum[load_of_b[k]], &sum_b, sizeof sum_b);
  }
  if (a >= 0) std::memcpy(&sum[a], &on_a, sizeof on_a);
}

template <bool Turning>
FURROW_WIDE void accelerate_loop(const DiscLoad* load, const DiscRates& rates, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    rates.ax[i] = load[i].fx * rates.inverse_mass[i];
    rates.ay[i] = load[i].fy * rates.inverse_mass[i] - rates.weight[i];
    if constexpr (Turning) rates.turning[i] = load[i].torque * rates.inverse_inertia[i];
  }
}

FURROW_WIDE void accelerate_lanes(const DiscLoad* load, const DiscRates& rates, std::size_t first, std::size_t last) {
  rates.turning ? accelerate_loop<true>(load, rates, first, last) : accelerate_loop<false>(load, rates, first, last);
}

// The tangential spring holds 1/2 St xi^2; it changes by the slip (St xi vt) and because St follows the overlap
// (1/2 xi^2 dSt/dt, `stiffening`), which no force pays for: a property of Mindlin's law without rescaling.
// First every lane, then the sums in the order of the contacts.
FURROW_WIDE void add_powers_lanes(const TouchBlock& c, bool friction, ContactPowers& sum) {
  TouchBlock::Lanes<double> viscous, sticking, sliding, rolling, stiffening;
  for (int k = 0; k < whole_lanes(c.count); ++k) {
    const double stick = -c.shear_stiffness[k] * c.spring[k] - c.shear_viscosity[k] * c.slip[k];
    const double lost = -c.tangential[k] * c.slip[k] - c.shear_stiffness[k] * c.spring[k] * c.slip[k];
    const bool sticks = stick == c.tangential[k];
    viscous[k] = (c.normal[k] - c.elastic[k]) * c.approach[k];
    sticking[k] = sticks ? lost : 0;
    sliding[k] = sticks ? 0 : lost;
    rolling[k] = c.moment[k] * (c.spin_a[k] - c.spin_b[k]);
    const double rate = 0.25 * c.spring[k] * c.spring[k] * c.shear_stiffness[k] * c.approach[k] / c.overlap[k];
    stiffening[k] = c.overlap[k] > 0 ? rate : 0;  // two discs exactly at touch have none
  }
  ContactPowers total = sum;
  for (int k = 0; k < c.count; ++k) {
    total.viscous += viscous[k];
    if (!friction) continue;
    total.viscous += sticking[k];
    total.friction += sliding[k];
    total.rolling -= rolling[k];
    total.stiffening += stiffening[k];
  }
  sum = total;
}

}  // namespace

FURROW_WIDTHS(bool, note_near, (const TouchBlock& c, std::uint32_t* near_at, const Nearness& nearness),
              (c, near_at, nearness))
FURROW_WIDTHS(void, evaluate, (TouchBlock & c, const ContactModel& model, bool returning, bool details),
              (c, model, returning, details))
FURROW_WIDTHS(void, add_loads, (const TouchBlock& c, const int* load_of_b, DiscLoad* sum), (c, load_of_b, sum))
FURROW_WIDTHS(void, add_powers, (const TouchBlock& c, bool friction, ContactPowers& sum), (c, friction, sum))
FURROW_WIDTHS(void, accelerate, (const DiscLoad* load, const DiscRates& rates, std::size_t first, std::size_t last),
              (load, rates, first, last))

void pair_up(TouchBlock& c, const DiscMotion& disc) {
  if (disc.spin) {
    disc.radius ? pair_up_loop<true, true>(c, disc) : pair_up_loop<true, false>(c, disc);
  } else {
    disc.radius ? pair_up_loop<false, true>(c, disc) : pair_up_loop<false, false>(c, disc);
  }
}

}  // namespace furrow
