// Where methods fail: the atlas of their stable steps, and what that means for scenes.
#include "verification/studies/scenes_stability.h"
#include "verification/studies/studies.h"

namespace furrow::verification {

Json stability(const Settings& settings) {
  Report report("Stability: where methods fail",
                "How long may a step be, method by method, and does the solver blow up where the theory says it must?");
  std::vector<double> zetas{0, 0.01, 0.1, 0.5, 1, 5};
  if (!settings.quick) zetas = {0, 0.01, 0.03, 0.1, 0.2, 0.5, 0.8, 1, 1.5, 2, 5, 10, 20};
  const std::vector<AtlasEntry> atlas = make_atlas(settings, zetas);
  const std::vector<StandingScene> scenes = standing_scenes(settings);
  std::vector<OperatingPoint> points;
  for (const StandingScene& s : scenes)
    if (s.name.find("scene ") == 0 && s.name.find("start") == std::string::npos) points.push_back(s.point);
  report_atlas(report, atlas, points);
  report_scenes(report, scenes);
  return report.json();
}

}  // namespace furrow::verification
