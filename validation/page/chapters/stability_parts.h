// The two parts of the chapter about stability.
#pragma once

#include "report/study.h"
#include "verification/studies/atlas.h"
#include "verification/studies/scenes_stability.h"

namespace furrow::validation {

// Where a scene stands: at its start, or as the plate is at the lattice.
struct Moment {
  std::string scene;  // "scene 3, discs"
  std::string when;   // "as the plate starts"
  std::string label;  // "scene 3, discs, 0 s"
};
Moment moment_of(const verification::StandingScene& scene);

// The scenes are marked in the atlas.
void report_atlas(Report& report, const std::vector<verification::AtlasEntry>& atlas,
                  const std::vector<verification::StandingScene>& scenes);

// Over the rim of the stable region of pece, see rim_of_pece.
void report_scenes(Report& report, const std::vector<verification::StandingScene>& scenes,
                   const std::vector<double>& rim);

}  // namespace furrow::validation
