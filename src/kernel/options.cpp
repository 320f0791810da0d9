#include "kernel/options.h"

#include "physics/contact_force.h"

namespace furrow {
namespace {

Touch touch_of(const TouchBatch& c, int k) {
  Touch t{};
  t.overlap = c.overlap[k];
  t.approach = c.vx[k] * c.nx[k] + c.vy[k] * c.ny[k];
  t.slip = c.vy[k] * c.nx[k] - c.vx[k] * c.ny[k] + (c.spin_a[k] * c.arm_a[k] + c.spin_b[k] * c.arm_b[k]);
  t.spring = c.spring[k];
  t.spin = c.spin_a[k] - c.spin_b[k];
  t.reduced_radius = c.reduced_radius[k];
  t.reduced_mass = c.reduced_mass[k];
  t.turn = c.turn[k];
  t.rolling_inertia = c.rolling_inertia[k];
  return t;
}

TouchForce force_of(const TouchBatch& c, int k) {
  return {c.elastic[k],   c.normal[k],          c.tangential[k],     c.moment[k],
          c.stiffness[k], c.shear_stiffness[k], c.shear_viscosity[k]};
}

void put(const TouchForce& f, TouchBatch& c, int k) {
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

void leave(TouchBatch& c, int k) {
  put({}, c, k);
  for (auto* field : {&c.fx, &c.fy, &c.torque_a, &c.torque_b, &c.slip, &c.spring_rate, &c.turn_rate}) (*field)[k] = 0;
}

}  // namespace

void evaluate_with_options(TouchBatch& c, const Parts& parts, bool returning) {
  for (int k = 0; k < c.count; ++k) {
    const ContactLaw& law = parts.law[c.law[k]];
    const bool touching = c.touching[k] != 0;
    const bool rolls = rolls_on_spring(law);
    Touch t = touch_of(c, k);
    TouchForce f = touching ? contact_force(law, t, parts.rolling_smoothing) : TouchForce{};
    if (returning) {
      c.held[k] = t.spring;
      c.turn_held[k] = t.turn;
      c.spring[k] = touching ? spring_after_step(law, t, f) : 0;
      c.turn[k] = touching && rolls ? turn_after_step(law, t, f) : touching ? t.turn : 0;
      t = touch_of(c, k);
      if (touching) f = contact_force(law, t, parts.rolling_smoothing);
    }
    if (!touching) {
      leave(c, k);
      continue;
    }
    put(f, c, k);
    c.approach[k] = t.approach;
    c.slip[k] = t.slip;
    c.spring_rate[k] = spring_rate(law, t, f);
    c.turn_rate[k] = rolls ? t.spin : 0;
  }
}

void gather_slots(TouchBatch& c, const Parts& parts, const Layout& at, const State& y) {
  for (int k = 0; k < c.count; ++k) {
    const int slot = c.slot[k];
    c.spring[k] = slot < 0 ? 0 : y[at.spring_of(slot)];
    if (!parts.rolling_spring) continue;
    c.turn[k] = slot < 0 ? 0 : y[at.turn_of(slot)];
    c.rolling_inertia[k] = rolling_inertia(parts, {c.kind, c.a[k], c.b[k]});
  }
}

void scatter_spring_rates(const TouchBatch& c, const Parts& parts, const Layout& at, State& dydt) {
  for (int k = 0; k < c.count; ++k) {
    if (c.slot[k] < 0) continue;
    dydt[at.spring_of(c.slot[k])] = c.spring_rate[k];
    if (parts.rolling_spring) dydt[at.turn_of(c.slot[k])] = c.turn_rate[k];
  }
}

Returned scatter_returned_slots(const TouchBatch& c, const Layout& at, State& y) {
  Returned returned{false, false};
  for (int k = 0; k < c.count; ++k) {
    if (c.slot[k] < 0) continue;
    y[at.spring_of(c.slot[k])] = c.spring[k];
    if (at.slot_width > 1) y[at.turn_of(c.slot[k])] = c.turn[k];
    const bool other = c.spring[k] != c.held[k] || c.turn[k] != c.turn_held[k];
    returned.changed = returned.changed || other;
    returned.stirred = returned.stirred || (other && c.touching[k] == 0);
  }
  return returned;
}

void add_powers_with_options(const TouchBatch& c, const Parts& parts, ContactPowers& sum) {
  for (int k = 0; k < c.count; ++k) {
    if (c.touching[k] == 0) continue;
    sum.add(contact_powers(parts.law[c.law[k]], touch_of(c, k), force_of(c, k)), parts.friction);
  }
}

void add_sliding_heat(const TouchBatch& c, const Parts& parts, double& sum) {
  for (int k = 0; k < c.count; ++k) {
    if (c.touching[k] != 0)
      sum += 0.5 * c.shear_stiffness[k] * (c.held[k] * c.held[k] - c.spring[k] * c.spring[k]);
    else
      sum += energy_at_opening(parts.law[c.law[k]], c.reduced_radius[k], c.held[k], c.turn_held[k]).tangential;
  }
}

void add_rolling_heat(const TouchBatch& c, const Parts& parts, double& sum) {
  for (int k = 0; k < c.count; ++k) {
    const ContactLaw& law = parts.law[c.law[k]];
    if (c.touching[k] == 0) {
      sum += energy_at_opening(law, c.reduced_radius[k], c.held[k], c.turn_held[k]).rolling;
      continue;
    }
    if (!rolls_on_spring(law)) continue;
    const double kr = rolling_stiffness(law, touch_of(c, k), force_of(c, k));
    sum += 0.5 * kr * (c.turn_held[k] * c.turn_held[k] - c.turn[k] * c.turn[k]);
  }
}

}  // namespace furrow
