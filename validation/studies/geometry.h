// What geometry was it? The paper leaves open the spacing of the lattice, the height of the plate, the radius in the
// contact of node and plate, and three rules. Scene 1 runs in milliseconds, so many settings are tried and the best of
// them are refined.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/measurement.h"

namespace furrow::validation {

struct Setting {
  double spacing = 0.01;         // m
  double depth = 0.025;          // m, of the plate's lower edge below the highest row
  double contact_radius = 0.01;  // m
  bool full_damper = false, magnitude = false;
};

// What the paper says of scene 1, each with how far off counts as one: a tenth of a force, 2 mm of a place. The place
// of the first torn link is one or not at all.
struct Target {
  std::string id;
  double want, unit_of_misfit;
  bool at_most;
};
const std::vector<Target>& targets();

struct Tried {
  Setting setting;
  std::vector<double> numbers;  // of the targets, to four digits; NaN: does not happen. None if the run failed
  double misfit;                // root mean square of those of the targets; infinite if the run failed
  bool failed() const { return numbers.empty(); }
  double misfit_of(std::size_t target) const;  // in its units
};

// A result of the study: for each of the settings the numbers of the targets, null for what does not happen, without the
// nulls at the end, or {"failed": why}.
struct Batch {
  std::string key;
  std::vector<Setting> settings;
};
using Ask = std::function<std::vector<Json>(const std::vector<Batch>&)>;

struct Search {
  Tried own;                 // the scene file's
  std::vector<Tried> tried;  // all, best first
};

// Draws settings, then neighbours of the best, a few rounds; `ask` runs them, or knows what they gave.
Search search_geometry(bool quick, const Ask& ask);

void measure_geometry(Measurement& measurement);

}  // namespace furrow::validation
