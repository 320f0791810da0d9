// Atom types and bond types of an exported scene.
//
// A disc's type is its material. A node is a sphere that does not turn; LAMMPS knows no point, so its radius is chosen,
// its law scaled to its contact radius, and what is flat stands back by the radius. Its type tells what moves it.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "system/parts.h"

namespace furrow {

struct AtomKind {
  int material = 0;
  double contact_radius = 0, radius = 0;  // m, of nodes; 0: a disc
  bool free = true, heavy = true, held_x = false, held_y = false;
  int drive = -1;
  bool operator==(const AtomKind&) const = default;
};

struct BondKind {
  double stiffness = 0, length = 0, strength = 0;  // N/m, m, N
  bool operator==(const BondKind&) const = default;
};

inline bool can_tear(const BondKind& kind) { return std::isfinite(kind.strength) && kind.stiffness > 0; }

struct AtomKinds {
  std::vector<AtomKind> kind;
  std::vector<int> of_disc, of_node;  // index into `kind`
  std::vector<BondKind> bond;
  std::vector<std::pair<int, int>> bonds;  // link, index into `bond`; without notches
};

// Throws std::invalid_argument if LAMMPS has not groups enough for them.
AtomKinds atom_kinds(const Parts& parts);

}  // namespace furrow
