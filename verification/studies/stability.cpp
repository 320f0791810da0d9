// Where methods fail: the atlas of their stable steps, and what that means for scenes.
#include "verification/studies/stability.h"

#include "verification/studies/atlas.h"
#include "verification/studies/scenes_stability.h"

namespace furrow::verification {

std::vector<double> atlas_ratios(bool quick) {
  if (quick) return {0, 0.01, 0.1, 0.5, 1, 5};
  return {0, 0.01, 0.03, 0.1, 0.2, 0.5, 0.8, 1, 1.5, 2, 5, 10, 20};
}

void measure_stability(Measurement& measurement) {
  measure_atlas(measurement, atlas_ratios(measurement.quick()));
  measure_standing_scenes(measurement);
}

}  // namespace furrow::verification
