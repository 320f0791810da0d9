// Where the paper is silent, contradicts itself or misprints, a key of the scene file takes the other reading: a run of
// each. The paper's statements themselves are judged by the ensemble; the quick form, which has none, makes a few members.
#pragma once

#include <string>
#include <vector>

#include "validation/studies/members.h"

namespace furrow::validation {

struct Gap {
  std::string setting;  // how a scene file asks for the other reading
  std::string scene;
  std::vector<std::string> shown;  // observables
  void (*change)(Scene&);
  std::string key() const { return scene + " " + setting; }
};

// `quick`: those of scene 1.
std::vector<Gap> gaps(bool quick);

void measure_statements(Measurement& measurement);

}  // namespace furrow::validation
