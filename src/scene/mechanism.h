// Motions of a lattice that meet no stiffness.
#pragma once

#include "scene/scene.h"

namespace furrow {

inline constexpr int most_nodes_of_a_mechanism = 300;  // a larger lattice would take too long

// How many independent small motions of the nodes stretch no link, beyond those of the lattice as a whole: from the
// eigenvalues of its stiffness matrix where it stands without displacements. A lattice without springs has none.
int free_motions(const Lattice& lattice);

}  // namespace furrow
