// The stability atlas: for each method the largest stable omega h over the damping ratio, by its amplification factor
// and by the solver's own blow-up. A new method comes in by itself.
#pragma once

#include "report/study.h"

namespace furrow::verification {

struct AtlasLimit {
  double zeta = 0;
  double theory = 0;               // -, omega h
  double spring = 0, contact = 0;  // -, measured on a link and on a contact
};

struct AtlasEntry {
  std::vector<std::string> methods;  // that share one theory; measured on the first
  bool by_eigenvalue = true;
  double real_axis = 0, imaginary_axis = 0;  // -, h |lambda|, by theory; the former only if by eigenvalue
  std::vector<AtlasLimit> limits;
};

// Of all methods of the catalogue that take fixed steps, own ones first; those with one amplification together.
std::vector<AtlasEntry> atlas_by_theory();

// With limits, by theory and measured, at these damping ratios.
std::vector<AtlasEntry> make_atlas(const Settings& settings, const std::vector<double>& zetas);

// Methods of the catalogue that stand in no entry: they choose their own step.
std::vector<std::string> methods_outside(const std::vector<AtlasEntry>& atlas);

// The scene's fastest part as an oscillator at a step, to be marked in the atlas.
struct OperatingPoint {
  double zeta, angle;
  std::string label;
};

void report_atlas(Report& report, const std::vector<AtlasEntry>& atlas, const std::vector<OperatingPoint>& points);

}  // namespace furrow::verification
