// Where methods fail: the atlas of their stable steps, and what that means for scenes.
#include "studies/atlas.h"
#include "studies/catalogue.h"

namespace furrow::studies {

Json stability(const Settings& settings) {
  Report report("Stability: where methods fail",
                "How long may a step be, method by method, and does the solver blow up where the theory says it must?");
  std::vector<double> zetas{0, 0.01, 0.1, 0.5, 1, 5};
  if (!settings.quick) zetas = {0, 0.01, 0.03, 0.1, 0.2, 0.5, 0.8, 1, 1.5, 2, 5, 10, 20};
  report_atlas(report, make_atlas(settings, zetas), {});
  return report.json();
}

}  // namespace furrow::studies
