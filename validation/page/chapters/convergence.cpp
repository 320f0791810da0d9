// Which of the numbers that the paper reports are those of its model, and which those of its time step?
#include "validation/studies/convergence.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "output/files.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/convergence_energy.h"
#include "validation/page/chapters/convergence_headline.h"
#include "validation/page/chapters/convergence_settled.h"

namespace furrow::validation {
namespace {

struct Row {
  std::string id, quantity;
  double paper = NAN;
};

std::vector<Row> rows_of(const std::string& scene) {
  std::vector<Row> rows{{"mean_force", "mean force [N]"}};
  for (const Statement& s : the_paper().statements) {
    if (s.scene == scene && s.observable != "finished")
      rows.push_back({s.id, s.quantity + (s.unit.empty() ? "" : " [" + s.unit + "]"), s.value});
  }
  return rows;
}

Json cell(const Numbers& results, const ConvergenceRun& one, const std::string& id) {
  if (failed(results, one)) return "diverged";
  const double value = value_in(results, one, id);
  return std::isfinite(value) ? Json(value) : Json("none");
}

// Adds the table of a case; counts what does not depend on the step at the paper's.
struct Tally {
  int numbers = 0, settled = 0, at_papers_step = 0;
  bool stable = true;  // by the paper's step
  void add(const Tally& other) {
    numbers += other.numbers;
    settled += other.settled;
    at_papers_step += other.at_papers_step;
    stable = stable && other.stable;
  }
};

// " By 0.1 ms the method makes ...: those numbers are the method's."
std::string unstable_steps(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c) {
  std::string list;
  for (const double step : plan.steps) {
    const std::string words = instability_words(results, {c, "pece", step});
    if (!words.empty()) list += (list.empty() ? " By " : ", by ") + in_ms(step) + " " + words;
  }
  return list.empty() ? "" : list + ": numbers by such a step are not the model's.";
}

Tally add_case(Report& report, const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c) {
  std::vector<std::string> head{"number", "the paper"};
  for (const double step : plan.steps) head.push_back("pece " + in_ms(step));
  for (const std::string& method : plan.others) head.push_back(method + " " + in_ms(plan.others_step));
  head.emplace_back("moved by a nudge");
  head.emplace_back("settled from");
  std::vector<std::vector<Json>> rows;
  Tally tally;
  for (const Row& row : rows_of(c.of_paper())) {
    const double finest = value_in(results, {c, "pece", plan.steps.back()}, row.id);
    if (!std::isfinite(finest) && !failed(results, {c, "pece", plan.steps.back()})) continue;  // said in words
    std::vector<Json> cells{row.quantity, std::isfinite(row.paper) ? Json(row.paper) : Json("")};
    for (const double step : plan.steps) cells.push_back(cell(results, {c, "pece", step}, row.id));
    for (const std::string& method : plan.others) cells.push_back(cell(results, {c, method, plan.others_step}, row.id));
    const double spread = spread_of(results, plan, c, row.id);
    const double from = settled_from(results, plan, c, row.id, spread);
    cells.push_back(std::isfinite(spread) ? Json(spread) : Json("none"));
    cells.emplace_back(std::isnan(from) ? "at no step tried" : in_ms(from));
    rows.push_back(cells);
    ++tally.numbers;
    tally.settled += std::isnan(from) ? 0 : 1;
    tally.at_papers_step += from >= papers_step ? 1 : 0;
  }
  tally.stable = instability_words(results, {c, "pece", papers_step}).empty();
  report.heading(c.title());
  report.table("Numbers by step and method, all from the same start." + unstable_steps(results, plan, c), head, rows);
  report.text(std::to_string(tally.settled) + " of these " + std::to_string(tally.numbers) +
              " numbers do not depend on a step that is fine enough; " + std::to_string(tally.at_papers_step) +
              " do not depend on it at the paper's step already.");
  return tally;
}

std::string in_plain_words(const std::string& reading, const Tally& tally) {
  const auto count = [](int n) { return n == 0 ? "none" : std::to_string(n); };
  std::string text = reading + ": ";
  if (tally.at_papers_step == tally.numbers)
    return text + "all " + count(tally.numbers) + " numbers are settled at the paper's step: they are the model's.";
  text += tally.settled == tally.numbers ? "all " + count(tally.numbers) + " numbers settle"
                                         : count(tally.settled) + " of " + count(tally.numbers) + " numbers settle";
  text += std::string(" when the step is made fine enough, and so are the model's; at the paper's step") +
          (tally.stable ? " " : ", by which the method makes more than all the energy that there is, ") +
          count(tally.at_papers_step) + " are settled, the other " + count(tally.numbers - tally.at_papers_step) +
          " depend on the step.";
  return text;
}

// N, at the steps below the paper's by which the method makes no more than all the energy that there is.
std::vector<double> sound_forces(const Numbers& results, const ConvergencePlan& plan, const ConvergenceCase& c,
                                 const std::string& id) {
  std::vector<double> sound;
  for (const double step : plan.steps) {
    const double force = step < papers_step ? value_in(results, {c, "pece", step}, id) : NAN;
    if (std::isfinite(force) && instability_words(results, {c, "pece", step}).empty()) sound.push_back(force);
  }
  return sound;
}

std::string largest_force_of(const std::string& scene) {
  return scene == "scenario_1"   ? "first_impact"
         : scene == "scenario_2" ? "largest_force_discs"
                                 : "largest_force_coupled";
}

}  // namespace

Report convergence(const Shelf& shelf) {
  const Numbers& results = shelf.of("convergence");
  const ConvergencePlan plan = convergence_plan(results.quick());
  Report report(
      "Are the published numbers those of the model, or of the time step?",
      "Each scene runs from one and the same start at steps from twice the paper's to a fiftieth of it, and by other "
      "methods. A number stands if it no longer changes when the step is made finer, by more than 2 % or than "
      "what a nudge of 1e-9 m/s to one body at the start does to it, and if the method does not make more than all the "
      "energy "
      "that the scene is given.");
  Report details("", "");  // of the figure
  Json blocks = Json::object();
  Tally all;
  std::map<std::string, Tally> by_reading;
  std::vector<ConvergedForce> found;
  std::string missing;
  std::vector<StepsOfCase> by_step;
  for (const ConvergenceCase& c : plan.cases) {
    if (!measured(results, plan, c)) {
      missing += (missing.empty() ? "" : "; ") + c.title();
      continue;
    }
    const std::string id = largest_force_of(c.of_paper());
    const double at_papers = value_in(results, {c, "pece", papers_step}, id);
    const double finest = value_in(results, {c, "pece", plan.steps.back()}, id);
    const double settled = settled_from(results, plan, c, id, spread_of(results, plan, c, id));
    if (!c.best())
      found.push_back({c, at_papers, finest, forces_by_step(results, plan, c, id), sound_forces(results, plan, c, id),
                       !std::isnan(settled), energy_made(results, {c, "pece", papers_step})});
    if (std::isfinite(finest)) {
      report.text(c.title() + (std::isfinite(at_papers)
                                   ? ": the largest force is " + rounded(at_papers) + " N at the paper's step and " +
                                         rounded(finest) + " N at " + in_ms(plan.steps.back()) + "." +
                                         unstable_steps(results, plan, c)
                                   : ": diverges at the paper's step."));
    }
    const Tally tally = add_case(details, results, plan, c);
    by_step.push_back({c, forces_by_step(results, plan, c, id), in_plain_words(c.title(), tally)});
    if (c.best()) {  // the headline and its counts are of the literal reading
      by_reading["The best valid reading of the search"].add(tally);
      continue;
    }
    all.add(tally);
    by_reading[c.scene == "scenario_1" ? "Scene 1" : "Scenes 2 and 3, " + to_string(c.reading) + "s"].add(tally);
    blocks["forces_" + c.scene.substr(9) + "_" + to_string(c.reading)] = by_step.back().forces;
  }
  for (const auto& [reading, tally] : by_reading) report.text(in_plain_words(reading, tally));
  if (!missing.empty())
    report.text("Not in the kept numbers, which are of an earlier form of this study: " + missing + ".");
  if (!results.quick()) {
    add_headline(report, found, {all.at_papers_step, all.numbers}, in_ms(plan.steps.back()));
    report.figure(
        {.name = "convergence",
         .script = "convergence.gp",
         .caption = "Largest force against the time step, by the paper's method; the paper's step is marked, its "
                    "numbers are the dotted lines. Of " +
                    std::to_string(all.numbers) +
                    " numbers of all scenes, as "
                    "discs and as spheres, " +
                    std::to_string(all.at_papers_step) + " do not depend on it.",
         .description = "Largest force on the plate against the time step for each scene and reading of the mass",
         .blocks = blocks});
  }
  add_energy(report, results, plan, by_step);
  report.append(details);
  return report;
}

}  // namespace furrow::validation
