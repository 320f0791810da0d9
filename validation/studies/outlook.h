// What the paper leaves to further study, as far as two dimensions go: the speed of the plate, the size of the
// particles and the spread of their sizes, each with some packings of its second scene.
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

void measure_outlook(Measurement& measurement);

}  // namespace furrow::validation
