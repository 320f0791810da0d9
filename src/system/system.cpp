#include "system/system.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>

#include "physics/link.h"

namespace furrow {
namespace {

// Slots for tangential springs. Discs in a plane touch at most six others each, three contacts a disc. In the paper's
// soft beds second neighbours touch too: up to 4.5 a disc were measured at its step (study outlook, discs of 8 mm).
int slots_needed(const Parts& p) {
  const long discs = p.disc.count();
  const long flat = static_cast<long>(p.wall.size() + p.plate.size());
  const long all = discs * (discs - 1) / 2 + discs * (flat + static_cast<long>(p.lattice.size())) + p.free_nodes * flat;
  return static_cast<int>(std::min(all, 5 * discs + p.free_nodes * flat + 16));
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
  spring_count_ = friction_ ? slots_needed(parts_) : 0;
  springs_ = 4 * bodies_ + spins;
  ledger_ = springs_ + spring_count_;
  slots_.nearness.margin = search_.margin;
  for (int k = spring_count_; k-- > 0;) slots_.unused.push_back(k);
  relaxed_.resize(static_cast<std::size_t>(spring_count_));

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
  const auto one_value = [](const auto& all) { return std::equal(all.begin() + 1, all.end(), all.begin()); };
  const DiscArrays& disc = parts_.disc;
  alike_ = disc.count() > 1 && one_value(disc.radius) && one_value(disc.mass) && one_value(disc.material);
  if (disc.count() > NeighbourSearch::discs_a_chunk) threads_ = scene.search.threads;
  const auto chunks = static_cast<std::size_t>(1 + disc.count() / NeighbourSearch::discs_a_chunk);
  chunk_powers_.resize(chunks);
  chunk_returned_.resize(chunks);
  disc_block_.resize(static_cast<std::size_t>(threads_));
  for (TouchBlock& c : disc_block_) {
    c.kind = disc_disc;
    if (!alike_) continue;
    c.law.fill(parts_.law_of(disc.material[0], disc.material[0]));
    c.reduced_radius.fill(disc.radius[0] * disc.radius[0] / (disc.radius[0] + disc.radius[0]));
    c.reduced_mass.fill(disc.mass[0] * disc.mass[0] / (disc.mass[0] + disc.mass[0]));
  }
  first_of_pair_.resize(parts_.disc.radius.size());
  second_of_pair_.resize(parts_.disc.radius.size());

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
  if (t == known_time_ && y.size() == known_.size()) {
    std::atomic<bool> differs = false;
    in_ranges(threads_, y.size(), [&](std::size_t first, std::size_t last) {
      if (std::memcmp(y.data() + first, known_.data() + first, (last - first) * sizeof y[0]) != 0) differs = true;
    });
    if (!differs) return copy_in_ranges(threads_, known_rates_, dydt);
  }
  add_up(t, y, nullptr, dydt, [](const TouchBlock& /*block*/, int /*chunk*/) {});
}

void System::look_around(double t, const State& y) const {
  place_nodes(y);
  search_.update(parts_, placement(t, y), threads_);
  if (search_.chunks.size() <= 1) pack_discs(y);
}

void System::begin_rates(const State& y, State& dydt) const {
  const auto speeds = static_cast<std::size_t>(2 * bodies_);
  in_ranges(threads_, speeds, [&](std::size_t first, std::size_t last) {
    std::copy(&y[speeds + first], &y[speeds] + last, &dydt[first]);
  });
  const auto rest = static_cast<std::size_t>(springs_);
  in_ranges(threads_, dydt.size() - rest, [&](std::size_t first, std::size_t last) {
    std::fill(dydt.data() + rest + first, dydt.data() + rest + last, 0.0);
  });
  disc_load_.resize(static_cast<std::size_t>(parts_.disc.count() + search_.spills));
  in_ranges(threads_, disc_load_.size(), [&](std::size_t first, std::size_t last) {
    std::fill(disc_load_.data() + first, disc_load_.data() + last, DiscLoad{});
  });
  std::fill(chunk_powers_.begin(), chunk_powers_.end(), ContactPowers{});
  std::copy(parts_.node.load_x.begin(), parts_.node.load_x.end(), node_fx_.begin());
  std::copy(parts_.node.load_y.begin(), parts_.node.load_y.end(), node_fy_.begin());
}

void System::add_contacts(const TouchBlock& c, int chunk, double t, State& dydt) const {
  if (c.kind == disc_disc) {
    kernel_->add(c, search_.chunks.size() > 1 ? c.load_of_b.data() : c.b.data(), disc_load_.data());
  } else if (of_disc(c.kind)) {
    for (int k = 0; k < c.count; ++k) {
      DiscLoad& sum = disc_load_[c.a[k]];
      sum.fx += c.fx[k];
      sum.fy += c.fy[k];
      sum.torque += c.torque_a[k];
    }
  } else {
    for (int k = 0; k < c.count; ++k) {
      node_fx_[c.a[k]] += c.fx[k];
      node_fy_[c.a[k]] += c.fy[k];
    }
  }
  if (c.kind == disc_lattice) {
    for (int k = 0; k < c.count; ++k) {
      const int i = parts_.border.a[c.segment[k]];
      const int j = parts_.border.b[c.segment[k]];
      node_fx_[i] -= (1 - c.share[k]) * c.fx[k];
      node_fy_[i] -= (1 - c.share[k]) * c.fy[k];
      node_fx_[j] -= c.share[k] * c.fx[k];
      node_fy_[j] -= c.share[k] * c.fy[k];
    }
  }
  if (friction_) {
    double* rate = dydt.data() + springs_;
    double nowhere = 0;
    for (int k = 0; k < c.count; ++k) *(c.slot[k] < 0 ? &nowhere : rate + c.slot[k]) = c.slip[k];
  }
  if (keeps_ledger_) add_to_ledger(c, chunk, t, dydt.data() + ledger_);
}

void System::join_chunks() const {
  const DiscLoad* spill = disc_load_.data() + parts_.disc.count();
  in_parallel(threads_, static_cast<int>(search_.spilled.size()), [&](int chunk, int /*thread*/) {
    for (const NeighbourSearch::Spill& s : search_.spilled[chunk]) {
      disc_load_[s.disc].fx += spill[s.number].fx;
      disc_load_[s.disc].fy += spill[s.number].fy;
      disc_load_[s.disc].torque += spill[s.number].torque;
    }
  });
  ContactPowers& all = chunk_powers_[0];
  for (std::size_t k = 1; k < chunk_powers_.size(); ++k) {
    all.viscous += chunk_powers_[k].viscous;
    all.friction += chunk_powers_[k].friction;
    all.rolling += chunk_powers_[k].rolling;
    all.stiffening += chunk_powers_[k].stiffening;
  }
}

void System::finish_rates(State& dydt) const {
  double* ax = dydt.data() + 2 * bodies_;
  double* ay = dydt.data() + 3 * bodies_;
  if (keeps_ledger_) {
    double* work = dydt.data() + ledger_;
    work[contact_viscous] = chunk_powers_[0].viscous;
    work[friction_work] = chunk_powers_[0].friction;
    work[rolling_work] = chunk_powers_[0].rolling;
    work[stiffening] = chunk_powers_[0].stiffening;
  }
  add_link_forces(keeps_ledger_ ? dydt.data() + ledger_ : nullptr);
  double* turning = friction_ ? dydt.data() + 4 * bodies_ : nullptr;
  in_ranges(threads_, static_cast<std::size_t>(parts_.disc.count()), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      ax[i] = disc_load_[i].fx * inverse_mass_[i];
      ay[i] = disc_load_[i].fy * inverse_mass_[i] - weight_[i];
    }
    for (std::size_t i = turning ? first : last; i < last; ++i) turning[i] = disc_load_[i].torque * inverse_inertia_[i];
  });
  for (int n = 0; n < parts_.node.count(); ++n) {
    const int body = parts_.node.body[n];
    if (body < 0) continue;
    ax[body] = node_fx_[n] * inverse_mass_[body];
    ay[body] = node_fy_[n] * inverse_mass_[body] - weight_[body];
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

void System::add_to_ledger(const TouchBlock& c, int chunk, double t, double* work) const {
  kernel_->add_powers(c, friction_, chunk_powers_[chunk]);
  if (c.kind != disc_plate && c.kind != node_plate) return;
  for (int k = 0; k < c.count; ++k) {
    const PlateAt at = plate_at(c.b[k], t);
    work[plate_work] += c.force_x(k) * at.vx + c.force_y(k) * at.vy;
  }
}

std::string System::velocity_dependence() const {
  std::string what;
  const auto add = [&what](bool depends, const std::string& name) {
    if (depends) what += (what.empty() ? "" : ", ") + name;
  };
  const bool touchable = parts_.disc.count() > 0 || !parts_.wall.empty() || !parts_.plate.empty();
  const auto damped = [](const ContactLaw& law) { return law.viscosity > 0; };
  add(touchable && std::any_of(parts_.law.begin(), parts_.law.end(), damped), "damping of contacts");
  add(touchable && friction_, "friction of contacts");
  for (std::size_t k = 0; k < parts_.lattice.size(); ++k) {
    bool any = false;
    for (int link = 0; link < parts_.link.count(); ++link)
      any = any || (parts_.link.damping[link] > 0 && parts_.node.lattice[parts_.link.a[link]] == static_cast<int>(k));
    add(any, "damping of the links of lattice " + parts_.lattice[k].name);
  }
  return what;
}

std::uint64_t System::state_hash(const State& y) const {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&hash](std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte, word >>= 8) hash = (hash ^ (word & 0xff)) * 0x100000001b3ULL;
  };
  for (int k = 0; k < springs_; ++k) add(std::bit_cast<std::uint64_t>(y[k]));
  for (int k = 0; k < spring_count_; ++k) {  // how much room there is for more does not count
    if (y[springs_ + k] == 0) continue;
    add(static_cast<std::uint64_t>(k));
    add(std::bit_cast<std::uint64_t>(y[springs_ + k]));
  }
  for (const char torn : torn_) add(static_cast<std::uint64_t>(torn));
  return hash;
}

}  // namespace furrow
