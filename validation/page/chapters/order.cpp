// Does each method have the order that it claims, on each kind of force that a scene contains, and where not, why?
#include <algorithm>
#include <cmath>

#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/failures.h"
#include "validation/page/chapters/order_parts.h"
#include "verification/studies/order_cure.h"

namespace furrow::validation {
namespace {

using namespace verification;

std::string of_all(int some, int all) { return std::to_string(some) + " of " + std::to_string(all) + " pairs"; }

void order_claims(Report& report, const Observations& all) {
  int cells = 0, positions = 0, velocities = 0;
  double furthest = 0;
  std::string misses;
  std::vector<double> tolerances;
  for (const auto& [cell, v] : all.verdicts) {
    if (!v.predicted) continue;
    ++cells;
    if (v.position.points >= 4) tolerances.push_back(v.position_gate);
    positions += v.position_holds ? 1 : 0;
    velocities += v.velocity_holds ? 1 : 0;
    if (v.position_holds)
      furthest = std::max({furthest, v.predicted->position - v.position.value, v.position.value - v.predicted->most});
    if (!v.position_holds) misses += (misses.empty() ? "" : ", ") + cell.first + " on " + cell.second;
  }
  std::sort(tolerances.begin(), tolerances.end());
  report.claim({.text = "In all pairs of a fixed-step method and a kind of force the observed order of the position is "
                        "the predicted one within three standard errors (Student's t of the fit) and twice what the "
                        "next power of the step does to the slope, or 0.05; but no more than half of what the order "
                        "would fall by with a method of one order less, and its points stand on a line (correlation)" +
                        (misses.empty() ? "." : "; except " + misses + "."),
                .value = of_all(positions, cells) + ", the furthest " + fixed(furthest, 2) + " off",
                .aim = "all, " + fixed(tolerances.at(tolerances.size() / 2), 2) + " off in the middle, " +
                       fixed(tolerances.back(), 2) + " at most",
                .holds = misses.empty()});
  report.headline({.tile = "right",
                   .value = of_all(positions, cells) + " of a method and a kind of force",
                   .text = "show the order that theory predicts, at most " + fixed(furthest, 2) + " off."});
  report.claim({.text = "So is the order of the velocity; after an elastic rebound or a tear that is located it is at "
                        "least the predicted one.",
                .value = of_all(velocities, cells),
                .aim = "all",
                .holds = velocities == cells});
}

void order_four_claim(Report& report, const Observations& all) {
  const auto at = [&](const char* method, const char* p) { return all.verdicts.at({method, p}).position; };
  const Slope two = at("pece", "damped_hertz"), four = at("rk4", "damped_hertz");
  report.claim({.text = "Through the touch of a damped Hertz contact twice the evaluations buy no order.",
                .value = "order " + with_error(four) + " of rk4, " + with_error(two) + " of pece",
                .aim = "equal within the tolerances of both",
                .holds = std::fabs(two.value - four.value) < tolerance_of(two) + tolerance_of(four)});
}

void cure_claims(Report& report, const Observations& all) {
  const auto cured = [&](const char* method, int grading) {
    return fitted(all.cured.at({method, "damped_hertz_inside", grading}), &Point::position);
  };
  const auto at = [&](const char* method, const char* p) { return all.verdicts.at({method, p}); };
  const auto from = [&](const char* method, const char* p) { return with_error(at(method, p).position) + " to "; };
  const Slope two = cured("pece", 2), four = cured("rk4", 4);
  report.claim(
      {.text = "Steps that end at the touch and grow from there restore the order in a damped Hertz contact. To locate "
               "the touch alone leaves rk4 " +
               with_error(cured("rk4", 1)) + ".",
       .value = "pece from " + from("pece", "damped_hertz_inside") + with_error(two) + " (g = 2), rk4 from " +
                from("rk4", "damped_hertz_inside") + with_error(four) + " (g = 4)",
       .aim = "2 and 4",
       .holds = std::fabs(two.value - 2) <= tolerance_of(two) && std::fabs(four.value - 4) <= tolerance_of(four)});
  const Verdict rk4 = at("rk4", "located_tear"), pece = at("pece", "located_tear");
  report.claim({.text = "To locate the tear within its step restores the order.",
                .value = "rk4 from " + from("rk4", "tear") + with_error(rk4.position) + ", pece from " +
                         from("pece", "tear") + with_error(pece.position),
                .aim = shown_order(rk4.predicted->position) + " and " + shown_order(pece.predicted->position),
                .holds = rk4.position_holds && pece.position_holds});
}

void rebound_claim(Report& report, const Observations& all) {
  const Verdict& v = all.verdicts.at({"pece", "hertz"});
  report.claim(
      {.text = "The speed after an elastic rebound converges faster than the motion, with pece. A check of the "
               "restitution alone would certify an order that the method does not have.",
       .value = "order " + with_error(v.velocity) + " of the speed, " + with_error(v.position) + " of the position",
       .aim = "more than 0.3 between them",
       .holds = v.velocity.value - v.position.value > 0.3});
}

void blind_claim(Report& report, const Observations& all) {
  std::string list;
  bool blind = true;
  for (const MethodInfo& method : method_catalogue()) {
    if (!method.controlled) continue;
    for (const char* p : {"tear", "stick_slip"}) {
      const auto found = all.points.find({method.name, p});
      if (found == all.points.end() || found->second.empty()) continue;
      const double gain = found->second.front().position / found->second.back().position;
      list += (list.empty() ? "" : ", ") + method.name + " on " + p + " " + fixed(gain, 1);
      blind = blind && gain < 300;
    }
  }
  report.claim({.text =
                    "Error control does not see what happens between steps: with the tolerance 100000 times smaller "
                    "the error falls only by these factors. A scene with friction or tears needs a largest step, or "
                    "events that are located.",
                .value = list,
                .aim = "all less than 300",
                .holds = blind && !list.empty()});
}

std::string how_errors_are_taken(const Series& series) {
  return "Errors against exact solutions, root of the mean square over " + std::to_string(series.phases) +
         " runs that begin at different places within a step, with steps and ends of their own; " +
         std::to_string(series.sizes) + " step sizes, each " + fixed(series.ratio, 2) +
         " times smaller than the one before (closer where a high order soon reaches round-off); the order is the "
         "slope of log error over log step, its error the standard error of that fit.";
}

}  // namespace

Report order(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("order");
  const Observations all = observations_of(numbers);
  Report report(
      "Order certificate",
      "Does each method have the order that it claims, on each kind of force that a scene contains, and where "
      "not, why?");
  order_claims(report, all);
  order_four_claim(report, all);
  cure_claims(report, all);
  rebound_claim(report, all);
  blind_claim(report, all);
  add_failures(report, numbers);
  report.text(how_errors_are_taken(order_series(numbers.quick())));
  kinds_table(report);
  report.figure(matrix_figure(all, false));
  report.figure(slopes_figure(all));
  report.figure(matrix_figure(all, true));
  report.heading("What restores the order");
  cure_table(report, all);
  report.heading("Error control");
  controlled_table(report, all);
  report.heading("Evaluations, the way back, energy");
  trends_table(report, all);
  report.figure(energy_figure(all));
  return report;
}

}  // namespace furrow::validation
