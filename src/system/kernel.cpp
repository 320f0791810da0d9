#include "system/kernel.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace furrow {
namespace {

// Inlined into functions for different processors, which a call could not be.
#define FURROW_LANES [[gnu::always_inline]] inline

FURROW_LANES int whole_lanes(int count) { return (count + TouchBlock::lanes - 1) & -TouchBlock::lanes; }

using Four [[gnu::vector_size(32)]] = double;

FURROW_LANES void pair_up(TouchBlock& c, const TouchBlock::DiscPair* first, const TouchBlock::DiscPair* second) {
  for (int k = 0; k < c.count; ++k) {
    const TouchBlock::DiscPair& p = first[c.a[k]];
    const TouchBlock::DiscPair& q = second[c.b[k]];
    c.pair[k] = {p.dx - q.dx,         p.dy - q.dy,
                 p.vx - q.vx,         p.vy - q.vy,
                 p.spin_a - q.spin_a, p.radius_a - q.radius_a,
                 p.spin_b - q.spin_b, p.radius_b - q.radius_b};
  }
}

FURROW_LANES void pair_up_scattered(TouchBlock& c, const DiscMotion& disc) {
  for (int k = 0; k < c.count; ++k) {
    const int a = c.a[k];
    const int b = c.b[k];
    c.pair[k] = {
        disc.x[b] - disc.x[a],        disc.y[b] - disc.y[a], disc.vx[a] - disc.vx[b],      disc.vy[a] - disc.vy[b],
        disc.spin ? disc.spin[a] : 0, disc.radius[a],        disc.spin ? disc.spin[b] : 0, disc.radius[b]};
  }
}

FURROW_LANES bool note_near(const TouchBlock& c, std::uint32_t* near_at, const Nearness& nearness) {
  const double margin = nearness.margin;
  const std::uint32_t now = nearness.now;
  TouchBlock::Lanes<std::uint32_t> near;
  for (int k = 0; k < c.count; ++k) {
    const TouchBlock::DiscPair& p = c.pair[k];
    const double reach = p.radius_a + p.radius_b + margin;
    near[k] = p.dx * p.dx + p.dy * p.dy < reach * reach ? 1 : 0;
  }
  std::uint32_t changes = 0;
  for (int k = 0; k < c.count; ++k) {
    near_at[k] = near[k] != 0 ? now : near_at[k];
    changes |= slot_changes(c.slot[k], near_at[k], now) ? 1 : 0;
  }
  return changes != 0;
}

// What the law needs of one contact, all kinds alike.
struct Lane {
  double nx, ny, overlap, vx, vy, spin_a, spin_b, radius_a, radius_b, arm_a, arm_b;
  bool touching;
};

FURROW_LANES Lane lane_of_discs(const TouchBlock& c, int k, double lever) {
  const TouchBlock::DiscPair& p = c.pair[k];
  const double half = 0.5 * lever;
  const double distance2 = p.dx * p.dx + p.dy * p.dy;
  const double within = p.radius_a + p.radius_b;
  const double distance = std::sqrt(distance2);
  const bool touching = distance2 < within * within;
  const double overlap = touching ? within - distance : 0;
  return {p.dx / distance,
          p.dy / distance,
          overlap,
          p.vx,
          p.vy,
          p.spin_a,
          p.spin_b,
          p.radius_a,
          p.radius_b,
          p.radius_a - half * overlap,
          p.radius_b - half * overlap,
          touching};
}

FURROW_LANES Lane lane_as_filled(const TouchBlock& c, int k) {
  return {c.nx[k],     c.ny[k],       c.overlap[k],  c.vx[k],    c.vy[k],    c.spin_a[k],
          c.spin_b[k], c.radius_a[k], c.radius_b[k], c.arm_a[k], c.arm_b[k], true};
}

// What only an onlooker and the ledger need.
FURROW_LANES void store_details(TouchBlock& c, int k, const Lane& lane, const TouchForce& f) {
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
FURROW_LANES void law_lanes(TouchBlock& c, const ContactModel& model) {
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
FURROW_LANES void choose_loop(TouchBlock& c, const ContactModel& model, bool first, Asked... asked) {
  if constexpr (sizeof...(asked) == 0) {
    first ? law_lanes<Known..., true>(c, model) : law_lanes<Known..., false>(c, model);
  } else {
    first ? choose_loop<Known..., true>(c, model, asked...) : choose_loop<Known..., false>(c, model, asked...);
  }
}

FURROW_LANES void evaluate(TouchBlock& c, const ContactModel& model, bool returning, bool details) {
  choose_loop<>(c, model, c.kind == disc_disc, model.one_law, model.rolling, returning, details);
}

// The pairs of one disc as `a` follow each other: its sum stays in a register. To load it all the same, and drop it,
// would mean to wait for the last store; so nothing is loaded from there.
FURROW_LANES void add(const TouchBlock& c, const int* load_of_b, DiscLoad* sum) {
  const Four sign{-1, -1, 1, 1};
  const DiscLoad none{};
  Four on_a{};
  int before = -1;
  for (int k = 0; k < c.count; ++k) {
    const int a = c.a[k];
    const int b = load_of_b[k];
    const Four load{c.fx[k], c.fy[k], c.torque_a[k], c.torque_b[k]};
    Four sum_a, sum_b;
    std::memcpy(&sum_a, a == before ? &none : &sum[a], sizeof sum_a);
    std::memcpy(&sum_b, &sum[b], sizeof sum_b);
    const auto same = -static_cast<long long>(a == before);
    const decltype(sum_a == sum_b) mask{same, same, same, same};
    on_a = (mask ? on_a : sum_a) + load;
    sum_b += sign * __builtin_shufflevector(load, load, 0, 1, 3, 3);
    std::memcpy(&sum[a], &on_a, sizeof on_a);
    std::memcpy(&sum[b], &sum_b, sizeof sum_b);
    before = a;
  }
}

// The tangential spring holds 1/2 St xi^2; it changes by the slip (St xi vt) and because St follows the overlap
// (1/2 xi^2 dSt/dt, `stiffening`), which no force pays for: a property of Mindlin's law without rescaling.
// First every lane, then the sums in the order of the contacts.
FURROW_LANES void add_powers(const TouchBlock& c, bool friction, ContactPowers& sum) {
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

// The loops above for one kind of processor.
// NOLINTBEGIN(bugprone-macro-parentheses): a name and an attribute cannot stand in parentheses
#define FURROW_KERNEL(width, target)                                                                                  \
  target void pair_up_##width(TouchBlock& c, const TouchBlock::DiscPair* first, const TouchBlock::DiscPair* second) { \
    pair_up(c, first, second);                                                                                        \
  }                                                                                                                   \
  target void pair_up_scattered_##width(TouchBlock& c, const DiscMotion& disc) { pair_up_scattered(c, disc); }        \
  target bool note_near_##width(const TouchBlock& c, std::uint32_t* near_at, const Nearness& n) {                     \
    return note_near(c, near_at, n);                                                                                  \
  }                                                                                                                   \
  target void evaluate_##width(TouchBlock& c, const ContactModel& model, bool returning, bool details) {              \
    evaluate(c, model, returning, details);                                                                           \
  }                                                                                                                   \
  target void add_powers_##width(const TouchBlock& c, bool friction, ContactPowers& sum) {                            \
    add_powers(c, friction, sum);                                                                                     \
  }                                                                                                                   \
  target void add_##width(const TouchBlock& c, const int* load_of_b, DiscLoad* sum) { add(c, load_of_b, sum); }       \
  constexpr Kernel kernel_##width{#width,           pair_up_##width, pair_up_scattered_##width, note_near_##width,    \
                                  evaluate_##width, add_##width,     add_powers_##width};
// NOLINTEND(bugprone-macro-parentheses)

FURROW_KERNEL(none, )
#ifdef __x86_64__
FURROW_KERNEL(avx2, [[gnu::target("avx2")]])
FURROW_KERNEL(avx512, [[gnu::target("avx512f,avx512dq,avx512vl,avx512bw")]])
#endif

const Kernel& choose() {
#ifdef __x86_64__
  const char* named = std::getenv("FURROW_VECTORS");
  const std::string_view wanted = named ? named : "avx512";
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (wanted == "avx512" && avx512) return kernel_avx512;
  if (wanted != "none" && __builtin_cpu_supports("avx2")) return kernel_avx2;
#endif
  return kernel_none;
}

}  // namespace

const Kernel& kernel() {
  static const Kernel& chosen = choose();
  return chosen;
}

}  // namespace furrow
