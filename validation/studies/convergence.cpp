// Which of the numbers that the paper reports are those of its model, and which those of its time step? Each scene runs
// from the same settled bed by several methods at steps down to a fiftieth of the paper's. Scenes 2 and 3 are chaotic:
// how far a number moves when the start is changed by far less than any step's error shows what no step can settle.
#include <algorithm>
#include <cmath>
#include <map>

#include "output/files.h"
#include "validation/studies/beds.h"
#include "validation/studies/observed_run.h"
#include "validation/studies/studies.h"

namespace furrow::validation {
namespace {

constexpr double papers_step = 1e-4;  // s
constexpr double nudge = 1e-9;        // m/s, on the first body
constexpr double agreement = 0.02;    // of a number: what "the same" means where nothing is chaotic
constexpr int nudged_runs = 3;

struct Case {
  std::string scene;
  Reading reading;
  std::string name() const { return scene + (scene == "scenario_1" ? "" : ", " + to_string(reading)); }
  std::string title() const {  // "Scene 2, discs"
    return "Scene " + scene.substr(9) + (scene == "scenario_1" ? "" : ", " + to_string(reading) + "s");
  }
};

struct One {
  Case of;
  std::string method;
  double step;     // s
  int nudged = 0;  // which of the nudged runs; 0: none
  std::string key() const {
    return of.name() + " " + method + " " + std::to_string(1e9 * step) + " " + std::to_string(nudged);
  }
};

Json run_of(const One& one, Beds& beds) {
  Prepared prepared = beds.of(one.of.scene, one.of.reading);
  prepared.y[prepared.system.vx_of(0)] += nudge * one.nudged;
  Timing time = prepared.scene.time;
  time.method = one.method;
  time.step = one.step;
  const RunRecord run = observed_run(std::move(prepared), time);
  Json got{{"ended", run.fact("ended")->texts.at(0)}, {"reason", run.fact("reason")->texts.at(0)}};
  Json& values = got["values"] = Json::object();
  for (const Reported& r : reported(run, the_paper(), one.of.scene)) {
    if (std::isfinite(r.ours.value)) values[r.id] = r.ours.value;
  }
  double sum = 0;
  for (const double f : run.force.f) sum += f;
  values["mean_force"] = sum / static_cast<double>(run.force.f.size());
  return got;
}

class Results {
 public:
  Results(std::vector<One> runs, std::vector<Json> got) : runs_(std::move(runs)), got_(std::move(got)) {}

  // NaN where the run did not get to the end, or does not say.
  double value(const One& one, const std::string& id) const {
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      if (runs_[k].key() != one.key()) continue;
      if (!got_[k].contains("values") || got_[k]["ended"] != "finished") return NAN;
      const Json& values = got_[k]["values"];
      return values.contains(id) ? values[id].get<double>() : NAN;
    }
    return NAN;
  }

  bool failed(const One& one) const {
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      if (runs_[k].key() == one.key()) return !got_[k].contains("values") || got_[k]["ended"] != "finished";
    }
    return false;
  }

 private:
  std::vector<One> runs_;
  std::vector<Json> got_;
};

struct Plan {
  std::vector<Case> cases;
  std::vector<double> steps;        // s, of pece; the last is the finest
  std::vector<std::string> others;  // methods that must agree at `others_step`
  double others_step, nudged_step;  // s
  std::vector<One> runs() const {
    std::vector<One> all;
    for (const Case& c : cases) {
      for (const double step : steps) all.push_back({c, "pece", step});
      for (const std::string& method : others) all.push_back({c, method, others_step});
      for (int n = 1; n <= nudged_runs; ++n) all.push_back({c, "pece", nudged_step, n});
    }
    std::stable_sort(all.begin(), all.end(), [](const One& a, const One& b) { return a.step < b.step; });
    return all;
  }
};

Plan plan_of(const Settings& settings) {
  if (settings.quick) return {{{"scenario_1", Reading::disc}}, {2e-4, 1e-4, 5e-5, 2e-5}, {"rk4"}, 2e-5, 2e-5};
  return {{{"scenario_1", Reading::disc},
           {"scenario_2", Reading::disc},
           {"scenario_3", Reading::disc},
           {"scenario_2", Reading::sphere},
           {"scenario_3", Reading::sphere}},
          {2e-4, 1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6},
          {"rk4", "verlet"},
          1e-5,
          1e-5};
}

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

// The coarsest step from which on every number stays within what chaos or `agreement` allows of the finest; NaN: none.
double settled_from(const Results& results, const Plan& plan, const Case& c, const std::string& id, double spread) {
  const double finest = results.value({c, "pece", plan.steps.back()}, id);
  const double allowed = std::max(spread, agreement * std::fabs(finest));
  double from = NAN;
  for (auto step = plan.steps.rbegin() + 1; step != plan.steps.rend(); ++step) {
    if (!(std::fabs(results.value({c, "pece", *step}, id) - finest) <= allowed)) break;
    from = *step;
  }
  for (const std::string& method : plan.others) {
    if (!(std::fabs(results.value({c, method, plan.others_step}, id) - finest) <= allowed)) return NAN;
  }
  return from;
}

double spread_of(const Results& results, const Plan& plan, const Case& c, const std::string& id) {
  const double base = results.value({c, "pece", plan.nudged_step}, id);
  double spread = 0;
  for (int n = 1; n <= nudged_runs; ++n)
    spread = std::max(spread, std::fabs(results.value({c, "pece", plan.nudged_step, n}, id) - base));
  return spread;
}

std::string text_of(double step) { return number(std::round(1e7 * step) / 1e4) + " ms"; }

// Whole newtons: "1135", not "1.13e+03".
std::string rounded(double force) {
  return force >= 100 ? std::to_string(std::lround(force)) : number(std::round(10 * force) / 10);
}

Json cell(const Results& results, const One& one, const std::string& id) {
  if (results.failed(one)) return "diverged";
  const double value = results.value(one, id);
  return std::isfinite(value) ? Json(value) : Json("none");
}

// Adds the table of a case; counts what does not depend on the step at the paper's.
struct Tally {
  int numbers = 0, settled = 0, at_papers_step = 0;
  void add(const Tally& other) {
    numbers += other.numbers;
    settled += other.settled;
    at_papers_step += other.at_papers_step;
  }
};

Tally add_case(Report& report, const Results& results, const Plan& plan, const Case& c) {
  std::vector<std::string> head{"number", "the paper"};
  for (const double step : plan.steps) head.push_back("pece " + text_of(step));
  for (const std::string& method : plan.others) head.push_back(method + " " + text_of(plan.others_step));
  head.emplace_back("moved by a nudge");
  head.emplace_back("does not depend on the step from");
  std::vector<std::vector<Json>> rows;
  Tally tally;
  for (const Row& row : rows_of(c.scene)) {
    const double finest = results.value({c, "pece", plan.steps.back()}, row.id);
    if (!std::isfinite(finest) && !results.failed({c, "pece", plan.steps.back()})) continue;  // said in words
    std::vector<Json> cells{row.quantity, std::isfinite(row.paper) ? Json(row.paper) : Json("")};
    for (const double step : plan.steps) cells.push_back(cell(results, {c, "pece", step}, row.id));
    for (const std::string& method : plan.others) cells.push_back(cell(results, {c, method, plan.others_step}, row.id));
    const double spread = spread_of(results, plan, c, row.id);
    const double from = settled_from(results, plan, c, row.id, spread);
    cells.push_back(std::isfinite(spread) ? Json(spread) : Json("none"));
    cells.emplace_back(std::isnan(from) ? "none tried" : text_of(from));
    rows.push_back(cells);
    ++tally.numbers;
    tally.settled += std::isnan(from) ? 0 : 1;
    tally.at_papers_step += from >= papers_step ? 1 : 0;
  }
  report.heading(c.title());
  report.table("Numbers by step and method, all from the same start.", head, rows);
  report.text(std::to_string(tally.settled) + " of these " + std::to_string(tally.numbers) +
              " numbers do not depend on a step that is fine enough; " + std::to_string(tally.at_papers_step) +
              " do not depend on it at the paper's step already.");
  return tally;
}

std::string in_plain_words(const std::string& reading, const Tally& tally) {
  const auto count = [](int n) { return std::to_string(n); };
  std::string text = "In plain words, for " + reading + ": ";
  if (tally.at_papers_step == tally.numbers)
    return text + "all " + count(tally.numbers) + " numbers are settled at the paper's step: they are the model's.";
  text += tally.settled == tally.numbers ? "all " + count(tally.numbers) + " numbers settle"
                                         : count(tally.settled) + " of " + count(tally.numbers) + " numbers settle";
  text += " when the step is made fine enough, and so are the model's; at the paper's step " +
          count(tally.at_papers_step) + " are settled, the other " + count(tally.numbers - tally.at_papers_step) +
          " depend on the step.";
  return text;
}

Json forces_by_step(const Results& results, const Plan& plan, const Case& c, const std::string& id) {
  Json rows = Json::array();
  for (const double step : plan.steps) {
    const double value = results.value({c, "pece", step}, id);
    if (std::isfinite(value)) rows.push_back({1e3 * step, value});
  }
  return rows;
}

std::string largest_force_of(const std::string& scene) {
  return scene == "scenario_1"   ? "first_impact"
         : scene == "scenario_2" ? "largest_force_discs"
                                 : "largest_force_coupled";
}

}  // namespace

Json convergence(const Settings& settings) {
  const Plan plan = plan_of(settings);
  const std::vector<One> runs = plan.runs();
  Beds beds;
  std::vector<Task> tasks;
  for (const One& one : runs) tasks.push_back({one.key(), [&beds, one] { return run_of(one, beds); }});
  const Results results(runs, run_tasks("convergence", settings, tasks));

  Report report(
      "Are the published numbers those of the model, or of the time step?",
      "Each scene runs from one and the same start at steps from twice the paper's to a fiftieth of it, and by other "
      "methods. A number stands if it no longer changes when the step is made finer, by more than 2 % or than "
      "what a nudge of 1e-9 m/s to one body at the start does to it.");
  Report details("", "");  // of the figure
  Json blocks = Json::object();
  Tally all;
  std::map<std::string, Tally> by_reading;
  for (const Case& c : plan.cases) {
    const std::string id = largest_force_of(c.scene);
    const double at_papers = results.value({c, "pece", papers_step}, id);
    const double finest = results.value({c, "pece", plan.steps.back()}, id);
    if (std::isfinite(finest)) {
      report.text(c.title() + (std::isfinite(at_papers)
                                   ? ": the largest force is " + rounded(at_papers) + " N at the paper's step and " +
                                         rounded(finest) + " N at " + text_of(plan.steps.back()) + "."
                                   : ": diverges at the paper's step."));
    }
    const Tally tally = add_case(details, results, plan, c);
    all.add(tally);
    by_reading[c.scene == "scenario_1" ? "scene 1" : "scenes 2 and 3, " + to_string(c.reading) + "s"].add(tally);
    blocks["forces_" + c.scene.substr(9) + "_" + to_string(c.reading)] =
        forces_by_step(results, plan, c, largest_force_of(c.scene));
  }
  for (const auto& [reading, tally] : by_reading) report.text(in_plain_words(reading, tally));
  if (!settings.quick) {
    report.figure(
        {.name = "convergence",
         .script = "convergence.gp",
         .caption =
             "Largest force against the time step, by the paper's method; the paper's step is marked, its numbers "
             "are the dotted lines. Of " +
             std::to_string(all.numbers) + " numbers of all scenes and readings " + std::to_string(all.at_papers_step) +
             " do not depend on the step at the paper's.",
         .description = "Largest force on the plate against the time step for each scene and reading of the mass",
         .blocks = blocks});
  }
  report.append(details);
  report.claim("At the paper's step some of its numbers are numbers of the step, not of the model.",
               all.at_papers_step < all.numbers);
  return report.json();
}

}  // namespace furrow::validation
