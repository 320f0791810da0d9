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

FURROW_LANES void disc_geometry(TouchBlock& c, double lever) {
  const double half = 0.5 * lever;
  for (int k = 0; k < whole_lanes(c.count); ++k) {
    const TouchBlock::DiscPair& p = c.pair[k];
    const double distance2 = p.dx * p.dx + p.dy * p.dy;
    const double within = p.radius_a + p.radius_b;
    const double distance = std::sqrt(distance2);
    const bool touching = distance2 < within * within;
    const double overlap = touching ? within - distance : 0;
    c.touching[k] = touching ? 1 : 0;
    c.nx[k] = p.dx / distance;
    c.ny[k] = p.dy / distance;
    c.overlap[k] = overlap;
    c.vx[k] = p.vx;
    c.vy[k] = p.vy;
    c.spin_a[k] = p.spin_a;
    c.spin_b[k] = p.spin_b;
    c.radius_a[k] = p.radius_a;
    c.radius_b[k] = p.radius_b;
    c.arm_a[k] = p.radius_a - half * overlap;
    c.arm_b[k] = p.radius_b - half * overlap;
  }
}

template <bool OneLaw, bool Rolling, bool Returning>
FURROW_LANES void law_lanes(TouchBlock& c, const ContactModel& model) {
  const ContactLaw* laws = model.law;
  const ContactLaw only = *laws;
  const double rolling_smoothing = model.rolling_smoothing;
  for (int k = 0; k < whole_lanes(c.count); ++k) {
    const ContactLaw& law = OneLaw ? only : laws[c.law[k]];
    const double approach = c.vx[k] * c.nx[k] + c.vy[k] * c.ny[k];
    const double slip = c.vy[k] * c.nx[k] - c.vx[k] * c.ny[k] + (c.spin_a[k] * c.arm_a[k] + c.spin_b[k] * c.arm_b[k]);
    Touch touch{c.overlap[k],        approach,         slip, c.spring[k], c.spin_a[k] - c.spin_b[k],
                c.reduced_radius[k], c.reduced_mass[k]};
    TouchForce f = hertz_mindlin<Rolling>(law, touch, rolling_smoothing);
    if constexpr (Returning) {
      touch.spring = c.touching[k] != 0 ? returned_spring(law, f, touch.spring) : 0;
      c.spring[k] = touch.spring;
      f = hertz_mindlin<Rolling>(law, touch, rolling_smoothing);
    }
    c.approach[k] = approach;
    c.slip[k] = c.touching[k] != 0 ? slip : 0;
    c.elastic[k] = f.elastic;
    c.normal[k] = f.normal;
    c.tangential[k] = f.tangential;
    c.moment[k] = f.moment;
    c.stiffness[k] = f.stiffness;
    c.shear_stiffness[k] = f.shear_stiffness;
    c.shear_viscosity[k] = f.shear_viscosity;
    c.fx[k] = -f.normal * c.nx[k] - f.tangential * c.ny[k];
    c.fy[k] = -f.normal * c.ny[k] + f.tangential * c.nx[k];
    c.torque_a[k] = c.arm_a[k] * f.tangential + f.moment;
    c.torque_b[k] = c.arm_b[k] * f.tangential - f.moment;
  }
}

template <bool OneLaw>
FURROW_LANES void choose_law(TouchBlock& c, const ContactModel& model, bool returning) {
  if (model.rolling) {
    returning ? law_lanes<OneLaw, true, true>(c, model) : law_lanes<OneLaw, true, false>(c, model);
  } else {
    returning ? law_lanes<OneLaw, false, true>(c, model) : law_lanes<OneLaw, false, false>(c, model);
  }
}

FURROW_LANES void evaluate(TouchBlock& c, const ContactModel& model, bool returning) {
  if (c.kind == disc_disc) disc_geometry(c, model.lever);
  model.one_law ? choose_law<true>(c, model, returning) : choose_law<false>(c, model, returning);
}

// The pairs of one disc as `a` follow each other: its sum stays in a register. To load it all the same, and drop it,
// would mean to wait for the last store; so nothing is loaded from there.
FURROW_LANES void add(const TouchBlock& c, DiscLoad* sum) {
  const Four sign{-1, -1, 1, 1};
  const DiscLoad none{};
  Four on_a{};
  int before = -1;
  for (int k = 0; k < c.count; ++k) {
    const int a = c.a[k];
    const int b = c.b[k];
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

// The loops above for one kind of processor.
// NOLINTBEGIN(bugprone-macro-parentheses): a name and an attribute cannot stand in parentheses
#define FURROW_KERNEL(width, target)                                                                                  \
  target void pair_up_##width(TouchBlock& c, const TouchBlock::DiscPair* first, const TouchBlock::DiscPair* second) { \
    pair_up(c, first, second);                                                                                        \
  }                                                                                                                   \
  target bool note_near_##width(const TouchBlock& c, std::uint32_t* near_at, const Nearness& n) {                     \
    return note_near(c, near_at, n);                                                                                  \
  }                                                                                                                   \
  target void evaluate_##width(TouchBlock& c, const ContactModel& model, bool returning) {                            \
    evaluate(c, model, returning);                                                                                    \
  }                                                                                                                   \
  target void add_##width(const TouchBlock& c, DiscLoad* sum) { add(c, sum); }                                        \
  constexpr Kernel kernel_##width{#width, pair_up_##width, note_near_##width, evaluate_##width, add_##width};
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
