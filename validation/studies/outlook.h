// What the paper leaves to further study, as far as two dimensions go: the speed of the plate, the size of the particles
// and the spread of their sizes, stiffness, damping and friction, each with some packings of its second scene; and a
// tool that bends against a rigid one.
#pragma once

#include <string>
#include <vector>

#include "report/measurement.h"

namespace furrow::validation {

struct OutlookVariation {
  std::string what, name;
  std::string unit;
  std::vector<double> values;
  double paper;  // the value of the paper's scene
  void (*apply)(Scene&, double);
};
const std::vector<OutlookVariation>& outlook_variations();

int outlook_packings(bool quick);
std::string outlook_key(const OutlookVariation& variation, double value, int packing);

// A lattice drawn through the bed (scene deformable_tool), or a plate of its size in its place, over the same way.
int tool_packings(bool quick);
std::string tool_key(bool rigid, int packing);
Task tool_task(bool rigid, int packing);  // mean_force, largest_force [N], fluctuation [-, deviation over mean], torn

void measure_outlook(Measurement& measurement);

}  // namespace furrow::validation
