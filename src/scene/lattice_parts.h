// The nodes and links of a lattice as its keys say: from rows and columns, or from a stem, with what is said of single
// nodes and links. A node has the number row * columns + column.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace furrow {

struct LatticeLink {
  int a, b;  // nodes, a < b
  LinkClass kind;
  double rest, stiffness, damping, strength;  // m, N/m, N s/m, N
  bool torn;                                  // from the start
};

// Structural, shear, bending; of a kind node by node.
std::vector<LatticeLink> links_of(const Lattice& lattice);

// Whether the link is one of those that the setting chooses.
bool chooses(const LinkSetting& setting, const Lattice& lattice, const LatticeLink& link);

struct Held {
  bool x = false, y = false;  // it keeps this coordinate, or is driven
  int drive = -1;             // which of the lattice's, -1: none
  bool fixed() const { return x && y; }
};
std::vector<Held> held_nodes(const Lattice& lattice);

double mass_of(const Lattice& lattice, int row, int column);  // kg

}  // namespace furrow
