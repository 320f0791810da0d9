// Lattices that are displaced so far at the start that they reach through themselves: a run would warn of it at t = 0.
#include <set>
#include <string>
#include <utility>

#include "scene/findings.h"
#include "scene/lattice_cell.h"
#include "scene/lattice_parts.h"
#include "scene/wording.h"

namespace furrow {
namespace {

// The first whole cell that has turned over; empty if none has.
std::string first_turned_over(const Lattice& l, const StandingLattice& here) {
  std::set<std::pair<int, int>> side;  // ends of the links that are not torn, the lower first
  for (const LatticeLink& link : links_of(l))
    if (!link.torn) side.insert({link.a, link.b});
  const auto whole = [&](int a, int b) { return side.contains({a, b}); };
  for (int row = 0; row + 1 < l.rows; ++row)
    for (int column = 0; column + 1 < l.columns; ++column) {
      const int a = row * l.columns + column, d = a + l.columns;
      if (!whole(a, a + 1) || !whole(a, d) || !whole(a + 1, d + 1) || !whole(d, d + 1)) continue;
      const auto& node = here.nodes();
      const std::string turned = turned_over({node[a], node[a + 1], node[d + 1], node[d]});
      if (!turned.empty())
        return "its cell at row " + std::to_string(row) + ", column " + std::to_string(column) + " " + turned;
    }
  return {};
}

}  // namespace

void judge_cells(const Scene& scene, Findings& found) {
  if (!found.sound() || (scene.allow && scene.allow->crossing_lattices.value_or(false))) return;
  for (std::size_t k = 0; k < scene.lattice.size(); ++k) {
    const Lattice& l = scene.lattice[k];
    if (l.node.empty()) continue;
    const StandingLattice here(l);
    if (const std::string turned = first_turned_over(l, here); !turned.empty())
      found.warning(item("lattice", k), turned + ": its links know lengths alone and hold it there");
    else if (here.crosses_itself())
      found.warning(item("lattice", k), "its border crosses itself: it does not feel that");
  }
}

}  // namespace furrow
