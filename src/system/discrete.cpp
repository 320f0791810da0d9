// The discrete state of a system, handed out and taken in.
#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "system/system.h"

namespace furrow {
namespace {

struct Counts {
  int a, b;
};

Counts counts_of(const Parts& parts, int kind) {
  const int discs = parts.disc.count(), nodes = parts.node.count();
  const int walls = static_cast<int>(parts.wall.size()), plates = static_cast<int>(parts.plate.size());
  switch (kind) {
    case disc_disc:
      return {discs, discs};
    case disc_wall:
      return {discs, walls};
    case disc_plate:
      return {discs, plates};
    case disc_lattice:
      return {discs, static_cast<int>(parts.lattice.size())};
    case node_wall:
      return {nodes, walls};
    case node_plate:
      return {nodes, plates};
    default:
      return {0, 0};
  }
}

bool before(const DiscreteState::Held& one, const DiscreteState::Held& other) {
  return std::tie(one.kind, one.a, one.b) < std::tie(other.kind, other.a, other.b);
}

// Every slot is held once or unused, every pair is one that there can be, links ascend.
bool belongs_to(const DiscreteState& d, const Parts& parts) {
  std::vector<char> seen(static_cast<std::size_t>(d.spring_count()), 0);
  const auto take = [&seen](int slot) {
    return slot >= 0 && slot < static_cast<int>(seen.size()) && !std::exchange(seen[slot], 1);
  };
  bool good = std::all_of(d.unused.begin(), d.unused.end(), take);
  for (const DiscreteState::Held& h : d.held) {
    const Counts most = counts_of(parts, h.kind);
    good = good && take(h.slot) && h.a >= 0 && h.a < most.a && h.b >= 0 && h.b < most.b;
  }
  for (std::size_t k = 1; k < d.held.size(); ++k) good = good && before(d.held[k - 1], d.held[k]);
  for (const int link : d.torn) good = good && link >= 0 && link < parts.link.count();
  return good;
}

}  // namespace

DiscreteState System::discrete_state() const {
  DiscreteState d{{}, {}, slots_.unused, slots_.now, preparing_};
  for (int link = 0; link < parts_.link.count(); ++link) {
    if (torn(link)) d.torn.push_back(link);
  }
  for (int kind = 0; kind < contact_kinds; ++kind) {
    const Candidates& list = search_.candidates[kind];
    for (int k = 0; k < list.count(); ++k) {
      if (list.slot[k] >= 0) d.held.push_back({kind, list.a[k], list.b[k], list.slot[k], list.near_at[k]});
    }
  }
  return d;
}

void System::restore(const DiscreteState& d) {
  if (!belongs_to(d, parts_) || (spares_ == 0 && d.spring_count() > 0))
    throw std::invalid_argument("the discrete state is not one of this scene");
  std::array<Candidates, contact_kinds> held;
  for (const DiscreteState::Held& h : d.held) {
    Candidates& list = held[h.kind];
    const int k = list.count();
    list.resize(k + 1);
    list.a[k] = h.a;
    list.b[k] = h.b;
    list.slot[k] = h.slot;
    list.near_at[k] = h.near_at;
  }
  search_.keep_only(held, parts_.disc.count());
  slots_.unused = d.unused;
  slots_.now = d.jumps;
  preparing_ = d.preparing;
  lay_out(d.spring_count());
  std::fill(torn_.begin(), torn_.end(), 0);
  for (const int link : d.torn) torn_[link] = 1;
  intact_.clear();
  for (int link = 0; link < parts_.link.count(); ++link) {
    if (!torn(link)) intact_.push_back(link);
  }
}

void DiscreteState::history(HistoryVisitor& visit) {
  visit("torn links", torn);
  std::vector<std::int64_t> table;
  for (const Held& h : held) table.insert(table.end(), {h.kind, h.a, h.b, h.slot, h.near_at});
  visit.integers("held slots", table);
  held.clear();
  for (std::size_t k = 0; k + 5 <= table.size(); k += 5) {
    const auto at = [&](std::size_t i) { return static_cast<int>(table[k + i]); };
    held.push_back({at(0), at(1), at(2), at(3), static_cast<std::uint32_t>(table[k + 4])});
  }
  visit("unused slots", unused);
  visit("jumps", jumps);
  visit("preparing", preparing);
}

}  // namespace furrow
