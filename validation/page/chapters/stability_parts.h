// The two parts of the chapter about stability.
#pragma once

#include "report/study.h"
#include "verification/studies/atlas.h"
#include "verification/studies/scenes_stability.h"

namespace furrow::validation {

// The scenes are marked in the atlas.
void report_atlas(Report& report, const std::vector<verification::AtlasEntry>& atlas,
                  const std::vector<verification::StandingScene>& scenes);

// Over the rim of the stable region of pece, see rim_of_pece.
void report_scenes(Report& report, const std::vector<verification::StandingScene>& scenes,
                   const std::vector<double>& rim);

}  // namespace furrow::validation
