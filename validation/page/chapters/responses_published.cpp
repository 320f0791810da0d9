// Impacts that others have computed or measured, beside the solver's.
#include <cmath>

#include "scene/wording.h"
#include "validation/page/chapters/responses_parts.h"
#include "verification/studies/kept_numbers.h"
#include "verification/studies/responses.h"

namespace furrow::validation {

using namespace verification;

std::string percent(double share, int digits) { return rounded(100 * share, digits) + " %"; }

void add_published_impacts(Report& report, const furrow::Numbers& numbers) {
  double worst = 0, off_measured = 0;  // shares of the published spin
  Json curve = Json::array(), computed = Json::array(), measured = Json::array();
  for (const double angle : oblique_angles()) curve.push_back({angle, numbers.at(oblique_key(angle))});
  const auto spin = [&](const PublishedSpin& p) { return number(numbers.at(oblique_key(p.angle))); };
  for (const PublishedSpin& p : computed_by_others()) {
    worst = std::fmax(worst, std::fabs(spin(p) / p.spin - 1));
    computed.push_back({p.angle, p.spin});
  }
  for (const PublishedSpin& p : measured_spins()) {
    off_measured = std::fmax(off_measured, std::fabs(spin(p) / p.spin - 1));
    measured.push_back({p.angle, p.spin});
  }
  report.heading("Published impacts");
  report.figure({.name = "oblique_spin",
                 .script = "oblique_spin.gp",
                 .caption =
                     "Spin of a sphere of aluminium oxide (2.5 mm, 3.9 m/s) after it has struck a plane, against the "
                     "angle from the normal: furrow, the computations that Chung and Ooi give, and the "
                     "measurements of Kharaz, Gorham and Salman.",
                 .description = "Spin after an oblique impact against its angle: furrow within " + percent(worst) +
                                " of the published computations, within " + percent(off_measured) + " of measurements",
                 .blocks = {{"curve", curve}, {"computed", computed}, {"measured", measured}}});
  add_published_numbers(report);
}

}  // namespace furrow::validation
