// The stability atlas: for each method the largest stable omega h over the damping ratio, by its amplification factor
// and by the solver's own blow-up. A new method comes in by itself.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "report/measurement.h"

namespace furrow::verification {

struct AtlasLimit {
  double zeta = 0;
  double theory = 0;               // -, omega h
  double spring = 0, contact = 0;  // -, measured on a link and on a contact
};

struct AtlasEntry {
  std::vector<std::string> methods;  // that have one amplification
  bool by_eigenvalue = true;
  double real_axis = NAN;  // -, h |lambda| on the negative real axis; NaN: not by eigenvalue
  bool conservative = false;
  std::vector<std::array<double, 2>> boundary{};  // zeta, omega h, by theory, up from the undamped edge
  std::vector<AtlasLimit> limits{};               // of all of them

  double limit_at(double zeta) const;  // -, on the boundary, between two of its points along the straight line
};

constexpr double undamped_at = 0.002;  // where a logarithmic axis shows a damping ratio of zero

// By theory, and measured, at these damping ratios; at none but zero of a method that takes no damping.
std::vector<AtlasLimit> limits_of(const std::string& method, const std::vector<double>& zetas);

// Of all methods of the catalogue that take fixed steps, own ones first; those with one amplification together. Without
// boundary and limits.
std::vector<AtlasEntry> atlas_by_theory();

void measure_atlas(Measurement& measurement, const std::vector<double>& zetas);
std::vector<AtlasEntry> atlas_of(const Numbers& numbers, const std::vector<double>& zetas);

// The rim of the stable region of pece over the direction of lambda, from the imaginary axis (0) to the negative real
// one (1): h |lambda|, at equal distances.
std::vector<double> rim_of_pece(const Numbers& numbers);

// Methods of the catalogue that stand in no entry: they choose their own step.
std::vector<std::string> methods_outside(const std::vector<AtlasEntry>& atlas);

}  // namespace furrow::verification
