#include "system/system.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "physics/link.h"

namespace furrow {
namespace {

// Slots for tangential springs. Discs in a plane touch at most six others each, three contacts a disc; a fourth for
// soft beds, whose second neighbours may touch, and for walls, plates and lattices.
int slots_needed(const Parts& p) {
  const long discs = p.disc.count();
  const long flat = static_cast<long>(p.wall.size() + p.plate.size());
  const long all = discs * (discs - 1) / 2 + discs * (flat + static_cast<long>(p.lattice.size())) + p.free_nodes * flat;
  return static_cast<int>(std::min(all, 4 * discs + p.free_nodes * flat + 16));
}

}  // namespace

System::System(const Scene& scene)
    : parts_(make_parts(scene)),
      gravity_(scene.model.gravity),
      lever_(scene.model.lever == Lever::overlap ? 1 : 0),
      rolling_smoothing_(scene.model.rolling_smoothing),
      keeps_ledger_(scene.output.energy),
      bodies_(parts_.bodies()),
      search_(parts_, scene.search) {
  // A spin matters only where a disc can be turned.
  for (const ContactLaw& law : parts_.law) {
    rolling_ = rolling_ || (law.rolling > 0 && parts_.disc.count() > 0);
    friction_ = friction_ || law.friction > 0;
  }
  friction_ = friction_ || rolling_;
  const int spins = friction_ ? parts_.disc.count() : 0;
  slots_ = friction_ ? slots_needed(parts_) : 0;
  springs_ = 4 * bodies_ + spins;
  ledger_ = springs_ + slots_;
  free_slots_.resize(static_cast<std::size_t>(slots_));
  for (int k = 0; k < slots_; ++k) free_slots_[k] = slots_ - 1 - k;

  for (int i = 0; i < parts_.disc.count(); ++i) {
    inverse_mass_.push_back(1 / parts_.disc.mass[i]);
    inverse_inertia_.push_back(1 / parts_.disc.inertia[i]);
    weight_.push_back(gravity_);
  }
  const NodeArrays& node = parts_.node;
  for (int n = 0; n < node.count(); ++n) {
    if (node.body[n] < 0) continue;
    inverse_mass_.push_back(1 / node.mass[n]);
    weight_.push_back(node.weight[n]);
  }
  torn_.assign(static_cast<std::size_t>(parts_.link.count()), 0);
  intact_.resize(torn_.size());
  std::iota(intact_.begin(), intact_.end(), 0);
  nodes_ = {node.x, node.y, node.vx, node.vy};
  for (int n = 0; n < node.count(); ++n) {
    if (node.body[n] < 0) nodes_.vx[n] = nodes_.vy[n] = 0;
  }
  node_fx_.resize(nodes_.x.size());
  node_fy_.resize(nodes_.x.size());

  disc_start_ = scene.disc;
}

State System::initial_state() const {
  State y(size(), 0.0);
  for (int i = 0; i < parts_.disc.count(); ++i) {
    const Disc& d = disc_start_[i];
    y[x_of(i)] = d.position.x;
    y[y_of(i)] = d.position.y;
    y[vx_of(i)] = d.velocity.x;
    y[vy_of(i)] = d.velocity.y;
    if (friction_) y[spin_of(i)] = d.spin;
  }
  const NodeArrays& node = parts_.node;
  for (int n = 0; n < node.count(); ++n) {
    const int body = node.body[n];
    if (body < 0) continue;
    y[x_of(body)] = node.x[n];
    y[y_of(body)] = node.y[n];
    y[vx_of(body)] = node.vx[n];
    y[vy_of(body)] = node.vy[n];
  }
  return y;
}

System::PlateAt System::plate_at(int plate, double t) const {
  const PlatePart& p = parts_.plate[plate];
  if (preparing_) return {p.left, p.lower, 0, 0};
  return {p.left + p.vx * t, p.lower + p.vy * t, p.vx, p.vy};
}

System::Nodes System::nodes(const State& y) const {
  place_nodes(y);
  return nodes_;
}

void System::place_nodes(const State& y) const {
  for (int n = 0; n < parts_.node.count(); ++n) {
    const int body = parts_.node.body[n];
    if (body < 0) continue;
    nodes_.x[n] = y[x_of(body)];
    nodes_.y[n] = y[y_of(body)];
    nodes_.vx[n] = y[vx_of(body)];
    nodes_.vy[n] = y[vy_of(body)];
  }
}

Placement System::placement(double t, const State& y) const {
  return {preparing_ ? 0 : t, y.data(), y.data() + bodies_, nodes_.x.data(), nodes_.y.data()};
}

void System::rhs(double t, const State& y, State& dydt) const {
  double* fx = dydt.data() + 2 * bodies_;
  double* fy = dydt.data() + 3 * bodies_;
  double* torque = dydt.data() + 4 * bodies_;
  std::copy(y.begin() + 2 * bodies_, y.begin() + 4 * bodies_, dydt.begin());
  std::fill(dydt.begin() + 2 * bodies_, dydt.end(), 0.0);
  std::copy(parts_.node.load_x.begin(), parts_.node.load_x.end(), node_fx_.begin());
  std::copy(parts_.node.load_y.begin(), parts_.node.load_y.end(), node_fy_.begin());
  double* work = keeps_ledger_ ? dydt.data() + ledger_ : nullptr;

  for_each_touch(t, y, [&](const TouchBlock& c) {
    const Candidates& list = search_.candidates[c.kind];
    for (int k = 0; k < c.count; ++k) {
      const double force_x = c.force_x(k);
      const double force_y = c.force_y(k);
      const int a = c.a[k];
      double* own_x = of_disc(c.kind) ? fx : node_fx_.data();
      double* own_y = of_disc(c.kind) ? fy : node_fy_.data();
      own_x[a] += force_x;
      own_y[a] += force_y;
      if (c.kind == disc_disc) {
        fx[c.b[k]] -= force_x;
        fy[c.b[k]] -= force_y;
      } else if (c.kind == disc_lattice) {
        const int i = parts_.border.a[c.segment[k]];
        const int j = parts_.border.b[c.segment[k]];
        node_fx_[i] -= (1 - c.share[k]) * force_x;
        node_fy_[i] -= (1 - c.share[k]) * force_y;
        node_fx_[j] -= c.share[k] * force_x;
        node_fy_[j] -= c.share[k] * force_y;
      }
    }
    if (friction_) {
      for (int k = 0; k < c.count; ++k) {
        const int slot = list.slot[c.candidate[k]];
        if (slot >= 0) dydt[springs_ + slot] = c.slip[k];
        if (of_disc(c.kind)) torque[c.a[k]] += c.arm_a[k] * c.tangential[k] + c.moment[k];
        if (c.kind == disc_disc) torque[c.b[k]] += c.arm_b[k] * c.tangential[k] - c.moment[k];
      }
    }
    if (work) add_to_ledger(c, work, t);
  });
  add_link_forces(work);

  for (int n = 0; n < parts_.node.count(); ++n) {
    const int body = parts_.node.body[n];
    if (body < 0) continue;
    fx[body] = node_fx_[n];
    fy[body] = node_fy_[n];
  }
  for (int i = 0; i < bodies_; ++i) {
    fx[i] *= inverse_mass_[i];
    fy[i] = fy[i] * inverse_mass_[i] - weight_[i];
  }
  if (friction_) {
    for (int i = 0; i < parts_.disc.count(); ++i) torque[i] *= inverse_inertia_[i];
  }
}

void System::add_link_forces(double* work) const {
  const LinkArrays& link = parts_.link;
  double damping = 0;
  for (const int k : intact_) {
    const int a = link.a[k];
    const int b = link.b[k];
    const LinkForce f =
        link_force(nodes_.x[a] - nodes_.x[b], nodes_.y[a] - nodes_.y[b], nodes_.vx[a] - nodes_.vx[b],
                   nodes_.vy[a] - nodes_.vy[b], link.rest[k], link.stiffness[k], link.damping[k], link.axial[k] != 0);
    node_fx_[a] += f.fx;
    node_fy_[a] += f.fy;
    node_fx_[b] -= f.fx;
    node_fy_[b] -= f.fy;
    damping += f.damping;
  }
  if (work) work[link_damping] = damping;
}

// Powers (W) by cause. The tangential spring holds 1/2 St xi^2; it changes by the slip (St xi vt) and because St
// follows the overlap (1/2 xi^2 dSt/dt, `stiffening`), which no force pays for: a property of Mindlin's law without
// rescaling.
void System::add_to_ledger(const TouchBlock& c, double* work, double t) const {
  const bool plate = c.kind == disc_plate || c.kind == node_plate;
  for (int k = 0; k < c.count; ++k) {
    work[contact_viscous] += (c.normal[k] - c.elastic[k]) * c.approach[k];
    if (plate) {
      const PlateAt at = plate_at(c.b[k], t);
      work[plate_work] += c.force_x(k) * at.vx + c.force_y(k) * at.vy;
    }
    if (!friction_) continue;
    const bool held = search_.candidates[c.kind].slot[c.candidate[k]] >= 0;
    const double stored = held ? c.shear_stiffness[k] * c.spring[k] * c.slip[k] : 0;
    const double lost = -c.tangential[k] * c.slip[k] - stored;
    const double stick = -c.shear_stiffness[k] * c.spring[k] - c.shear_viscosity[k] * c.slip[k];
    work[stick == c.tangential[k] ? contact_viscous : friction_work] += lost;
    work[rolling_work] -= c.moment[k] * (c.spin_a[k] - c.spin_b[k]);
    if (c.overlap[k] > 0) {  // two discs exactly at touch have none
      work[stiffening] += 0.25 * c.spring[k] * c.spring[k] * c.shear_stiffness[k] * c.approach[k] / c.overlap[k];
    }
  }
}

std::uint64_t System::state_hash(const State& y) const {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&hash](std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte, word >>= 8) hash = (hash ^ (word & 0xff)) * 0x100000001b3ULL;
  };
  for (int k = 0; k < ledger_; ++k) add(std::bit_cast<std::uint64_t>(y[k]));
  for (const char torn : torn_) add(static_cast<std::uint64_t>(torn));
  return hash;
}

}  // namespace furrow
