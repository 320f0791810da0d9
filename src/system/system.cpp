#include "system/system.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "methods/floating_point.h"

namespace furrow {
namespace {

// Slots for tangential springs at first; a jump makes more where they do not suffice. Discs in a plane touch at most
// six others each, three contacts a disc. In the paper's soft beds second neighbours touch too: up to 4.5 a disc were
// measured at its step (study outlook, discs of 8 mm).
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
  const DefaultFloatingPoint environment;
  // A spin matters only where a disc can be turned.
  for (const ContactLaw& law : parts_.law) {
    rolling_ = rolling_ || (law.rolling > 0 && parts_.disc.count() > 0);
    friction_ = friction_ || law.friction > 0;
  }
  friction_ = friction_ || rolling_;
  const int spins = friction_ ? parts_.disc.count() : 0;
  springs_ = 4 * bodies_ + spins;
  const int chunks = 1 + parts_.disc.count() / NeighbourSearch::discs_a_chunk;
  const int slots = friction_ ? slots_needed(parts_) : 0;
  spares_ = slots > 0 ? chunks : 0;
  lay_out(slots);
  for (int k = spring_count_; k-- > 0;) slots_.unused.push_back(k);

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
  if (disc.count() > 1 && one_value(disc.material)) law_of_pairs_ = parts_.law_of(disc.material[0], disc.material[0]);
  alike_ = law_of_pairs_ >= 0 && one_value(disc.radius) && one_value(disc.mass);
  if (disc.count() > NeighbourSearch::discs_a_chunk) threads_ = scene.search.threads;
  chunk_powers_.resize(static_cast<std::size_t>(chunks));
  chunk_returned_.resize(static_cast<std::size_t>(chunks));
  chunk_seen_.resize(static_cast<std::size_t>(chunks));
  disc_block_.resize(static_cast<std::size_t>(threads_));
  flat_block_.touching.fill(1);  // the others are left out of it
  wall_block_.kind = disc_wall;
  if (alike_) wall_block_.radius_a.fill(disc.radius[0]);
  for (TouchBlock& c : disc_block_) {
    if (!alike_) continue;
    c.law.fill(law_of_pairs_);
    c.radius_a.fill(disc.radius[0]);
    c.radius_b.fill(disc.radius[0]);
    c.reduced_radius.fill(disc.radius[0] * disc.radius[0] / (disc.radius[0] + disc.radius[0]));
    c.reduced_mass.fill(disc.mass[0] * disc.mass[0] / (disc.mass[0] + disc.mass[0]));
  }

  disc_start_ = scene.disc;
}

void System::lay_out(int spring_count) {
  spring_count_ = spring_count;
  ledger_ = springs_ + spring_count_ + spares_;
}

void System::fit(State& y) const {
  const std::size_t after_springs = size() - static_cast<std::size_t>(springs_ + spring_count_);
  Growth{size() - y.size(), after_springs}.apply(y);
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
