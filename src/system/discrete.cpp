#include "system/discrete.h"

#include <algorithm>
#include <utility>

#include "system/border.h"
#include "system/order.h"

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

bool before(const DiscreteState::Held& one, const DiscreteState::Held& other) { return comes_before(one, other); }

}  // namespace

DiscreteState initial_discrete_state(const Parts& parts, const Layout& layout) {
  DiscreteState d;
  d.torn = parts.link.notched;
  d.border = touched_segments(parts, d.torn);
  for (int k = layout.spring_count; k-- > 0;) d.unused.push_back(k);
  return d;
}

bool is_torn(const DiscreteState& d, int link) { return std::binary_search(d.torn.begin(), d.torn.end(), link); }

int slot_of(const DiscreteState& d, const ContactId& c) {
  const DiscreteState::Held sought{c.kind, c.a, c.b, -1, 0};
  const auto found = std::lower_bound(d.held.begin(), d.held.end(), sought, before);
  return found == d.held.end() || before(sought, *found) ? -1 : found->slot;
}

namespace {

bool faces_belong_to(const HeldFaces& faces, const Parts& parts) {
  bool good = parts.tight_plates || faces.empty();
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const HeldFace& f = faces[k];
    const Counts most = counts_of(parts, f.kind);
    good = good && (f.kind == disc_plate || f.kind == node_plate) && f.face >= left_face && f.face <= upper_face;
    good = good && f.a >= 0 && f.a < most.a && f.b >= 0 && f.b < most.b;
    good = good && (f.kind == disc_plate || parts.node.body[f.a] >= 0);
    good = good && (k == 0 || comes_before(faces[k - 1], f));
  }
  return good;
}

}  // namespace

bool belongs_to(const DiscreteState& d, const Parts& parts) {
  std::vector<char> seen(static_cast<std::size_t>(d.spring_count()), 0);
  const auto take = [&seen](int slot) {
    return slot >= 0 && slot < static_cast<int>(seen.size()) && !std::exchange(seen[slot], 1);
  };
  bool good = std::all_of(d.unused.begin(), d.unused.end(), take);
  for (const DiscreteState::Held& h : d.held) {
    const Counts most = counts_of(parts, h.kind);
    good = good && take(h.slot) && h.a >= 0 && h.a < most.a && h.b >= 0 && h.b < most.b;
    good = good && (h.kind != disc_disc || h.a < h.b);
    good = good && (h.kind < node_wall || parts.node.body[h.a] >= 0);
  }
  for (std::size_t k = 1; k < d.held.size(); ++k) good = good && before(d.held[k - 1], d.held[k]);
  for (const int link : d.torn) good = good && link >= 0 && link < parts.link.count();
  good = good && std::is_sorted(d.torn.begin(), d.torn.end()) &&
         std::adjacent_find(d.torn.begin(), d.torn.end()) == d.torn.end();
  return good && faces_belong_to(d.faces, parts);
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
  visit.list("held faces", faces, [&](HeldFace& f) {
    visit("kind", f.kind);
    visit("a", f.a);
    visit("b", f.b);
    visit("face", f.face);
  });
}

}  // namespace furrow
