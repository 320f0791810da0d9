// A round rod as a lattice: rows of cells one spacing s high, c = columns - 1 of them side by side, from edge to edge of
// the rod. x is measured from its middle.
//
//   A = pi d^2/4,  I = pi d^4/64,  G = E/(2 (1 + nu)),  s = d/c, but for a whole number of rows in its length
//   k_d  along a diagonal, two in each cell
//   k_h  across, half of it from each of the cells above and below
//   k_j  along, of column j
//
// Under a strain e(x) along the rod a cell grows across by -nu s e(x_m), freely, x_m its middle. So it resists with k_c:
//
//   nu  = k_d/(k_d + k_h),  k_c = k_d k_h/(k_d + k_h)
//   EA  = s (sum of k_j + c k_c)
//   EI  = s^3 (sum of k_j (x_j/s)^2 + k_c sum of (x_m/s)^2)
//   GA  = s c k_d
//
// GA gives k_d, nu gives k_h; EA and EI give k_j, one value for the two edges and one for the columns between. A link
// tears where it is longer by the strain strength/E: in tension at strength A, in bending, as the edges lie d/2 from the
// middle, at strength I/(d/2). Masses are those of the cells' quarters. Dampers are tau k, tau = 2 zeta/omega: of the
// first bending motion of the clamped rod, omega = 1.8751^2 sqrt(EI/(rho A L^4)), the share zeta of critical damping.
#pragma once

#include "scene/scene.h"

namespace furrow {

struct StemSprings {
  double edge, inner, across, diagonal;  // N/m
  double relaxation;                     // s, damping over stiffness
  double tear_strain;                    // -
};
StemSprings springs_of(const Stem& stem, const Lattice& lattice);

// Whether springs that pull back have its EA and EI: with few columns, of a rod that is not short.
bool has_springs(const Stem& stem, const Lattice& lattice);

// Rows, spacing and node mass of all lattices that are stems.
void fill_stems(std::vector<Lattice>& lattices, const std::vector<Material>& materials);
inline void fill_stems(Scene& scene) { fill_stems(scene.lattice, scene.material); }

inline constexpr int least_stem_columns = 3, most_stem_columns = 5;
inline constexpr double first_bending = 1.8751040687119611;  // root of cos x cosh x = -1

}  // namespace furrow
