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
  std::vector<std::vector<Json>> rows;
  const auto add = [&](const std::string& what, const std::string& source, double got, double wanted) {
    rows.push_back({what, source, kept(got, 4), wanted, percent(got / wanted - 1)});
    return std::fabs(got / wanted - 1);
  };
  const std::string chung = "Chung and Ooi 2011, ", kharaz = "measured: Kharaz, Gorham and Salman 2001";
  const Json& glass = numbers.at(glass_key);
  double worst =
      add("Two spheres of glass, greatest overlap [µm]", chung + "test 1", 1e6 * number(glass["overlap"]), 274);
  worst = std::fmax(
      worst, add("Two spheres of glass, greatest force [kN]", chung + "test 1", 1e-3 * number(glass["force"]), 10.70));
  worst = std::fmax(
      worst, add("Two spheres of glass, contact time [µs]", chung + "test 1", 1e6 * number(glass["time"]), 40.5));
  Json curve = Json::array(), computed = Json::array(), measured = Json::array();
  for (const double angle : oblique_angles()) curve.push_back({angle, numbers.at(oblique_key(angle))});
  const auto spin = [&](const PublishedSpin& p) { return number(numbers.at(oblique_key(p.angle))); };
  const auto words = [](double angle) {
    return "Sphere of aluminium oxide at " + rounded(angle, 3) + "°, spin after the impact [rad/s]";
  };
  double off_measured = 0;
  for (const PublishedSpin& p : computed_by_others()) {
    worst = std::fmax(worst, add(words(p.angle), chung + "test 4", spin(p), p.spin));
    computed.push_back({p.angle, p.spin});
  }
  for (const PublishedSpin& p : measured_spins()) {
    off_measured = std::fmax(off_measured, add(words(p.angle), kharaz, spin(p), p.spin));
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
  report.table(
      "Numbers that others have published. Values that are read off figures are good to a percent or two; what was "
      "measured has errors of its own.",
      {"case", "source", "furrow", "published", "difference"}, rows);
  report.claim({.text = "Published computations of impacts, furrow's number off from them, the worst.",
                .value = percent(worst),
                .aim = "at most 5 %, for they are read off figures and their tangential laws differ",
                .holds = worst <= 0.05});
}

}  // namespace furrow::validation
