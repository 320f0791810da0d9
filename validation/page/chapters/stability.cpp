// Where methods fail: the atlas of their stable steps, and what that means for scenes.
#include "verification/studies/stability.h"

#include "output/files.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/failures.h"
#include "validation/page/chapters/stability_parts.h"

namespace furrow::validation {

Moment moment_of(const verification::StandingScene& s) {
  Moment moment{s.name, "at the start", s.name};
  if (!s.of_the_paper()) return moment;
  for (const std::string when : {", start", ", plate at the lattice"})  // as the kept numbers name them
    if (s.name.ends_with(when)) moment.scene = s.name.substr(0, s.name.size() - when.size()) + ", discs";
  moment.when = s.t <= 0              ? "as the plate starts"
                : s.name == "scene 1" ? "as the plate meets the lattice"
                                      : "as the plate is where the paper has it meet the lattice";
  moment.label = moment.scene + ", " + number(s.t) + " s";
  return moment;
}

Report stability(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("stability");
  Report report("Stability: where methods fail",
                "How long may a step be, method by method, and does the solver blow up where the theory says it must?");
  add_failures(report, numbers);
  const auto scenes = verification::standing_scenes(numbers);
  report_atlas(report, verification::atlas_of(numbers, verification::atlas_ratios(numbers.quick())), scenes);
  report_scenes(report, scenes, verification::rim_of_pece(numbers));
  return report;
}

}  // namespace furrow::validation
