// The jump map: what happens between steps.
#include <algorithm>
#include <cmath>

#include "system/system.h"

namespace furrow {
namespace {

// Accepted steps without nearness after which a slot may pass to another contact: longer than the history of any
// multistep method, so that nothing of the old contact reaches the new one.
constexpr int quiet_steps = 8;

}  // namespace

JumpReport System::jump(double t, State& y) {
  JumpReport report;
  if (friction_) {
    return_to_coulomb_limit(t, y, report);
    arm_contacts(t, y);
  }
  if (!preparing_) tear_links(t, y, report);
  return report;
}

// |xi| <= mu Fn / St; and a spring whose contact has opened is relaxed.
void System::return_to_coulomb_limit(double t, State& y, JumpReport& report) {
  relaxed_.assign(static_cast<std::size_t>(slots_), 0.0);
  for_each_touch(t, y, [&](const TouchBlock& c) {
    for (int k = 0; k < c.count; ++k) {
      const int slot = search_.candidates[c.kind].slot[c.candidate[k]];
      if (slot < 0) continue;
      const double pressed = c.normal[k] > 0 ? c.normal[k] : 0;
      const double limit = parts_.law[c.law[k]].friction * pressed / c.shear_stiffness[k];
      const double spring = c.spring[k];
      const double returned = spring > limit ? limit : spring < -limit ? -limit : spring;
      relaxed_[slot] = returned;
      if (keeps_ledger_ && returned != spring) {
        y[ledger_of(friction_work)] += 0.5 * c.shear_stiffness[k] * (spring * spring - returned * returned);
      }
    }
  });
  const auto springs = y.begin() + springs_;
  report.springs_changed = !std::equal(relaxed_.begin(), relaxed_.end(), springs);
  std::copy(relaxed_.begin(), relaxed_.end(), springs);
}

// Near contacts get a slot, contacts that have long been apart give it back.
void System::arm_contacts(double t, const State& y) {
  const double* radius = parts_.disc.radius.data();
  const Placement now = placement(t, y);
  for (int kind = 0; kind < contact_kinds; ++kind) {
    Candidates& list = search_.candidates[kind];
    for (int k = 0; k < list.count(); ++k) {
      bool near = false;
      if (kind == disc_disc) {
        const double dx = y[x_of(list.b[k])] - y[x_of(list.a[k])];
        const double dy = y[y_of(list.b[k])] - y[y_of(list.a[k])];
        const double within = radius[list.a[k]] + radius[list.b[k]] + search_.margin;
        near = dx * dx + dy * dy < within * within;
      } else if (kind == disc_lattice) {
        int segment = 0;
        near = std::sqrt(nearest_border(now, k, segment).distance2) - radius[list.a[k]] < search_.margin;
      } else {
        near = flat_gap(parts_, now, static_cast<ContactKind>(kind), list.a[k], list.b[k]).gap < search_.margin;
      }
      if (near) {
        list.quiet[k] = 0;
        if (list.slot[k] >= 0) continue;
        if (free_slots_.empty()) {
          throw Divergence("more contacts than a plane holds (" + std::to_string(slots_) + " tangential springs)");
        }
        list.slot[k] = free_slots_.back();
        free_slots_.pop_back();
      } else if (list.slot[k] >= 0 && ++list.quiet[k] > quiet_steps) {
        free_slots_.push_back(list.slot[k]);
        list.slot[k] = -1;
      }
    }
  }
}

void System::tear_links(double t, State& y, JumpReport& report) {
  if (intact_.empty()) return;
  place_nodes(y);
  const LinkArrays& link = parts_.link;
  double released = 0;
  for (const int k : intact_) {
    const double rx = nodes_.x[link.a[k]] - nodes_.x[link.b[k]];
    const double ry = nodes_.y[link.a[k]] - nodes_.y[link.b[k]];
    const double stretch = std::sqrt(rx * rx + ry * ry) - link.rest[k];
    const double force = link.stiffness[k] * stretch;
    if (!((link.in_magnitude[k] != 0 ? std::fabs(force) : force) > link.strength[k])) continue;
    report.torn.push_back({t, k, force});
    released += 0.5 * force * stretch;
  }
  if (report.torn.empty()) return;
  // A torn segment of the border lets go of the disc on it, and of what that contact held.
  if (keeps_ledger_) released += lattice_contact_energy(t, y);
  for (const Tear& tear : report.torn) torn_[tear.link] = 1;
  std::erase_if(intact_, [this](int k) { return torn_[k] != 0; });
  if (keeps_ledger_) y[ledger_of(tear_energy)] += released - lattice_contact_energy(t, y);
}

double System::lattice_contact_energy(double t, const State& y) const {
  double energy = 0;
  for_each_touch(t, y, [&](const TouchBlock& c) {
    if (c.kind != disc_lattice) return;
    for (int k = 0; k < c.count; ++k) energy += stored_energy(c, k);
  });
  return energy;
}

}  // namespace furrow
