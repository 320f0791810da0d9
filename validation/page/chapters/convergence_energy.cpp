#include "validation/page/chapters/convergence_energy.h"

#include <algorithm>
#include <cmath>

#include "validation/page/chapters/convergence_settled.h"

namespace furrow::validation {
namespace {

std::string percent(double share) { return three_digits(100 * share) + " %"; }

// step ms, share of what the scene was given in percent; what is below a millionth is drawn as a millionth.
Json made_by_step(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c) {
  constexpr double least = 1e-6;
  Json rows = Json::array();
  for (const double step : plan.steps) {
    const double made = energy_made(results, {c, "pece", step});
    if (std::isfinite(made)) rows.push_back({1e3 * step, 100 * std::max(made, least)});
  }
  return rows;
}

std::string energy_words(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c) {
  const double papers = energy_made(results, {c, "pece", papers_step}),
               finest = energy_made(results, {c, "pece", plan.steps.back()});
  const std::string at_papers = std::isfinite(papers) ? percent(papers) + " of all the energy that the scene was given"
                                                      : std::string("more than can be booked: it diverges");
  return "The method makes " + at_papers + " at the paper's step" +
         (std::isfinite(finest) ? ", " + percent(finest) + " at " + three_digits(1e3 * plan.steps.back()) + " ms."
                                : ".");
}

Figure figure_of(const Numbers& results, const ConvergencePlan& plan, const StepsOfCase& literal,
                 const StepsOfCase& best) {
  const std::string scene = literal.c.of_paper().substr(9);
  return {
      .name = "convergence_scene_" + scene,
      .script = "convergence_scene.gp",
      .caption = "Scene " + scene +
                 ": largest force and energy made, of all that the scene was given, against the time step, by the "
                 "literal reading and by the best valid one.",
      .description = "Largest force on the plate and energy made by the method against the time step, scene " + scene,
      .blocks = {{"forces_literal", literal.forces},
                 {"forces_best", best.forces},
                 {"made_literal", made_by_step(results, plan, literal.c)},
                 {"made_best", made_by_step(results, plan, best.c)}}};
}

}  // namespace

void add_energy(Report& report, const Numbers& results, const ConvergencePlan& plan,
                const std::vector<StepsOfCase>& cases) {
  report.heading("The energy that the method makes");
  const auto booked = [&](const StepsOfCase& s) { return !made_by_step(results, plan, s.c).empty(); };
  if (std::none_of(cases.begin(), cases.end(), booked)) {
    report.text("The kept numbers are of an earlier form of this study, which did not book the energy.");
    return;
  }
  for (const StepsOfCase& literal : cases) {
    if (literal.c.best() || literal.c.reading != Reading::disc || !booked(literal)) continue;
    report.text(literal.words + " " + energy_words(results, plan, literal.c));
    const auto best = std::find_if(cases.begin(), cases.end(), [&](const StepsOfCase& s) {
      return s.c.best() && s.c.of_paper() == literal.c.scene && booked(s);
    });
    if (best == cases.end()) continue;
    report.text(best->words + " " + energy_words(results, plan, best->c));
    report.figure(figure_of(results, plan, literal, *best));
  }
}

}  // namespace furrow::validation
