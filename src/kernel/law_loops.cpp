// The loops of the contact law over a batch.
#include "kernel/loops.h"
#include "kernel/wide.h"

namespace furrow {
namespace {

// The law in two loops: the shorter the chain of dependent operations of a lane, the more lanes the processor overlaps.
template <bool OneLaw, bool Rolling, bool Returning, bool AllFields>
FURROW_WIDE void law_lanes(TouchBatch& c, const ContactModel& model) {
  const ContactLaw* laws = model.law;
  const ContactLaw only = *laws;
  const double rolling_smoothing = model.rolling_smoothing;
  for (int k = 0; k < c.whole_lanes(); ++k) {
    const ContactLaw& law = OneLaw ? only : laws[c.law[k]];
    const double approach = c.vx[k] * c.nx[k] + c.vy[k] * c.ny[k];
    TouchForce f{};
    press(law, {c.overlap[k], approach, 0, 0, 0, c.reduced_radius[k], c.reduced_mass[k]}, f);
    c.normal[k] = f.normal;
    c.shear_stiffness[k] = f.shear_stiffness;
    c.shear_viscosity[k] = f.shear_viscosity;
    if constexpr (AllFields) {
      c.approach[k] = approach;
      c.elastic[k] = f.elastic;
      c.stiffness[k] = f.stiffness;
    }
  }
  for (int k = 0; k < c.whole_lanes(); ++k) {
    const ContactLaw& law = OneLaw ? only : laws[c.law[k]];
    const double nx = c.nx[k];
    const double ny = c.ny[k];
    const bool touching = c.touching[k] != 0;
    const double slip = c.vy[k] * nx - c.vx[k] * ny + (c.spin_a[k] * c.arm_a[k] + c.spin_b[k] * c.arm_b[k]);
    Touch touch{c.overlap[k], 0, slip, c.spring[k], c.spin_a[k] - c.spin_b[k], c.reduced_radius[k], 0};
    TouchForce f{0, c.normal[k], 0, 0, 0, c.shear_stiffness[k], c.shear_viscosity[k]};
    const double limit = coulomb_limit(law, f);
    if constexpr (Returning) {
      c.held[k] = touch.spring;
      touch.spring = touching ? returned_spring(limit, f, touch.spring) : 0;
      c.spring[k] = touch.spring;
    }
    f.tangential = tangential_force(touch, f, limit);
    if constexpr (Rolling) f.moment = rolling_moment(law, touch, f.normal, rolling_smoothing);
    if constexpr (AllFields) {
      c.tangential[k] = f.tangential;
      c.moment[k] = f.moment;
    }
    c.slip[k] = touching ? slip : 0;
    c.fx[k] = -f.normal * nx - f.tangential * ny;
    c.fy[k] = -f.normal * ny + f.tangential * nx;
    c.torque_a[k] = c.arm_a[k] * f.tangential + f.moment;
    c.torque_b[k] = c.arm_b[k] * f.tangential - f.moment;
  }
}

// Chooses the loop compiled for these options.
template <bool... Known, class... Asked>
FURROW_WIDE void choose_loop(TouchBatch& c, const ContactModel& model, bool first, Asked... asked) {
  if constexpr (sizeof...(asked) == 0) {
    first ? law_lanes<Known..., true>(c, model) : law_lanes<Known..., false>(c, model);
  } else {
    first ? choose_loop<Known..., true>(c, model, asked...) : choose_loop<Known..., false>(c, model, asked...);
  }
}

FURROW_WIDE void evaluate_lanes(TouchBatch& c, const ContactModel& model, Evaluation asked) {
  choose_loop<>(c, model, model.one_law, model.rolling, asked.returning, asked.all_fields);
}

// First all lanes, then the sums in the order of the contacts.
FURROW_WIDE void add_powers_lanes(const TouchBatch& c, bool friction, ContactPowers& sum) {
  TouchBatch::Lanes<double> viscous, sticking, sliding, rolling, stiffening;
  for (int k = 0; k < c.whole_lanes(); ++k) {
    const TouchPowers p = touch_powers(
        {c.overlap[k], c.approach[k], c.slip[k], c.spring[k], c.spin_a[k] - c.spin_b[k], 0, 0},
        {c.elastic[k], c.normal[k], c.tangential[k], c.moment[k], 0, c.shear_stiffness[k], c.shear_viscosity[k]});
    viscous[k] = p.viscous;
    sticking[k] = p.sticking;
    sliding[k] = p.sliding;
    rolling[k] = p.rolling;
    stiffening[k] = p.stiffening;
  }
  ContactPowers total = sum;
  for (int k = 0; k < c.count; ++k)
    total.add({viscous[k], sticking[k], sliding[k], rolling[k], stiffening[k]}, friction);
  sum = total;
}

}  // namespace

FURROW_WIDTHS(void, evaluate, (TouchBatch & c, const ContactModel& model, Evaluation asked), (c, model, asked))
FURROW_WIDTHS(void, add_powers, (const TouchBatch& c, bool friction, ContactPowers& sum), (c, friction, sum))

}  // namespace furrow
