#include "export/kinds.h"

#include <algorithm>
#include <stdexcept>

#include "system/place.h"

namespace furrow {
namespace {

constexpr std::size_t most_kinds = 24;  // LAMMPS has 32 groups, and some are for other things
constexpr double of_plate = 0.45;       // of its lesser side: a node sees a plate that is left after two radii

template <class Kind>
int index_of(std::vector<Kind>& all, const Kind& one) {
  const auto at = std::find(all.begin(), all.end(), one);
  if (at != all.end()) return static_cast<int>(at - all.begin());
  all.push_back(one);
  return static_cast<int>(all.size()) - 1;
}

double node_radius(const Parts& parts, double contact_radius) {
  double radius = contact_radius;
  for (const PlatePart& p : parts.plate) radius = std::min({radius, of_plate * p.width, of_plate * p.height});
  return radius;
}

AtomKind kind_of_node(const Parts& parts, int node) {
  const NodeArrays& n = parts.node;
  const auto held = [&](const std::vector<int>& bodies) {
    return n.body[node] >= 0 && std::find(bodies.begin(), bodies.end(), n.body[node]) != bodies.end();
  };
  return {.material = n.material[node],
          .contact_radius = n.contact_radius[node],
          .radius = node_radius(parts, n.contact_radius[node]),
          .free = n.body[node] >= 0,
          .heavy = n.gravity[node] != 0,
          .held_x = held(parts.held_x),
          .held_y = held(parts.held_y),
          .drive = n.drive[node]};
}

}  // namespace

AtomKinds atom_kinds(const Parts& parts) {
  AtomKinds all;
  all.of_disc.resize(parts.disc.material.size());
  for (const int i :
       places_in(parts.disc.number))  // as the scene lists them, so that a deck of its own scene is the same
    all.of_disc[static_cast<std::size_t>(i)] = index_of(all.kind, {.material = parts.disc.material[i]});
  for (int k = 0; k < parts.node.count(); ++k) all.of_node.push_back(index_of(all.kind, kind_of_node(parts, k)));
  for (int k = 0; k < parts.link.count(); ++k) {
    if (std::binary_search(parts.link.notched.begin(), parts.link.notched.end(), k)) continue;
    const BondKind kind{parts.link.stiffness[k], parts.link.rest[k], parts.link.strength[k]};
    all.bonds.emplace_back(k, index_of(all.bond, kind));
  }
  if (all.kind.size() > most_kinds)
    throw std::invalid_argument("LAMMPS has 32 groups of atoms: it cannot tell " + std::to_string(all.kind.size()) +
                                " sorts of discs or nodes apart (materials, fixed, held, driven, with weight)");
  return all;
}

}  // namespace furrow
