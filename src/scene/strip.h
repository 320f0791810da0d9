// A lattice as a beam: the strip that its rows make along its longer side, far from its ends. Of the links the keys of
// the lattice count, not what is said of single ones.
#pragma once

#include <optional>

#include "scene/scene.h"

namespace furrow {

struct Beam {
  double tension, bending, shear;  // N, N m^2, N: EA, EI, GA
  double poisson;                  // -, of the strip in tension
  double mass;                     // kg/m
  double length;                   // m, from the outermost line that is held to the free end
  bool held;                       // whether any line is
  bool isotropic;                  // as a sheet of many such cells
  double tearing_strain;           // -, in tension; infinity: it does not tear
  double tearing_curvature;        // 1/m, in bending

  double diameter() const;         // m, of the round rod with the same EA and EI
  double young() const;            // Pa, of that rod
  double first_frequency() const;  // Hz, of the clamped beam, bending alone: 1.8751^2/(2 pi L^2) sqrt(EI/mass)
  double tip_compliance() const;   // m/N: L^3/(3 EI) + L/GA
  double tearing_tension() const { return tension * tearing_strain; }               // N
  double tearing_tip_load() const { return bending * tearing_curvature / length; }  // N, on the tip, across
};

// Nothing for a chain of one row or one column: it does not resist bending.
std::optional<Beam> beam_of(const Lattice& lattice);

}  // namespace furrow
