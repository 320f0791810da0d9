// What does accuracy cost, and which method gives it for least? Error against evaluations and CPU time, every method on
// every case.

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/wording.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/precision_chart.h"
#include "validation/page/chapters/work_precision_found.h"
#include "validation/page/names.h"

namespace furrow::validation {
namespace {

using namespace benchmarks;

constexpr std::array<double, 4> targets{1e-2, 1e-3, 1e-4, 1e-6};

Json number_or_dash(double value) { return std::isnan(value) ? Json("–") : Json(value); }

// CPU time in ms.
Json in_unit(double value, double WorkPrecisionPoint::*cost) {
  return number_or_dash(cost == &WorkPrecisionPoint::cpu ? 1e3 * value : value);
}

// ---- what is shown ----

void add_gains(Report& report, const std::vector<Found>& all) {
  std::vector<std::vector<Json>> rows;
  for (const Found& f : all) {
    const WorkPrecisionPoint* paper = paper_point(f);
    std::vector<std::pair<std::string, double>> asked;
    if (paper)
      asked.emplace_back(rounded(paper->error_by(f.info.by_force), 2) + ", the paper's",
                         paper->error_by(f.info.by_force));
    for (const double target : targets) asked.emplace_back(rounded(target, 2), target);
    for (const auto& [words, error] : asked) {
      std::vector<Json> row{scene_words(f.info.name), words};
      for (const auto cost : {&WorkPrecisionPoint::evaluations, &WorkPrecisionPoint::cpu}) {
        const bool blind = error < floor_of(f);
        const Cheapest best = blind ? Cheapest{} : cheapest_at(f, error, cost);
        const double own = paper && error == paper->error_by(f.info.by_force)
                               ? paper->*cost
                               : cost_at(paper_curve(f), error, f.info.by_force, cost);
        row.emplace_back(blind ? "not resolved" : best.method.empty() ? "none" : best.method);
        row.push_back(in_unit(best.cost, cost));
        row.push_back(in_unit(own, cost));
        row.push_back(number_or_dash(own / best.cost));
      }
      rows.push_back(row);
    }
  }
  report.table(
      "The cheapest method at an error, what the paper's method (pece) needs for it, and how many times dearer that "
      "is. "
      "At the paper's own error that is the paper's setting, pece at 0.1 ms. A method must keep the error with every "
      "finer setting; costs between two settings are read off the straight line in logarithms. Not resolved: below "
      "what the "
      "references can distinguish.",
      {"scene", "error", "fewest evaluations", "evaluations", "pece", "times dearer", "least CPU", "CPU [ms]",
       "pece [ms]", "times dearer"},
      rows);
}

// Why no method with a bounded stable interval can be much cheaper: of the fixed-step methods Euler's covers most of
// the negative real axis an evaluation, 2 (see the stability study; Hairer and Wanner, Solving Ordinary Differential
// Equations II, section IV.2).
std::string bound(const Found& f, double papers) {
  if (!f.fastest.is_number()) return "";
  const double fastest = f.fastest, least = fastest * (f.info.span.end() - f.info.span.start) / 2;
  return " In " + scene_words(f.info.name) + " the fastest decay where the chart begins is " + rounded(fastest, 2) +
         " 1/s, so the others are stable with " + rounded(least, 2) + " evaluations or more, " +
         fixed(100 * least / papers, 0) + " % of the paper's; an error of a few per cent may be reached with fewer.";
}

// What the paper's own error costs another method, case by case.
void add_paper(Report& report, const std::vector<Found>& all) {
  std::vector<std::vector<Json>> rows;
  std::string missed, why;
  std::size_t held = 0;
  for (const Found& f : all) {
    const std::string name = scene_words(f.info.name);
    const WorkPrecisionPoint* paper = paper_point(f);
    if (!paper) {
      rows.push_back({name, "the paper's setting fails"});
      missed += "; " + name + ": the paper's setting fails";
      continue;
    }
    const double error = paper->error_by(f.info.by_force);
    const Cheapest by_count = cheapest_at(f, error, &WorkPrecisionPoint::evaluations);
    const Cheapest by_cpu = cheapest_at(f, error, &WorkPrecisionPoint::cpu);
    const double count = by_count.cost / paper->evaluations;
    const double cpu = by_cpu.cost / paper->cpu;
    rows.push_back({name, rounded(error, 2), by_count.method, fixed(100 * count, 1) + " %", by_cpu.method,
                    fixed(100 * cpu, 1) + " %"});
    if (count <= 1.0 / 3 && cpu <= 1.0 / 3) {
      ++held;
    } else {
      missed += "; " + name + ": " + fixed(100 * count, 1) + " % and " + fixed(100 * cpu, 1) + " %";
      why += bound(f, paper->evaluations);
    }
  }
  report.claim({.text = "another method reaches the paper's error for at most a third of the paper's evaluations, and "
                        "one for at most a third of its CPU time" +
                        (missed.empty() ? "." : ". Not so: " + missed.substr(2) + "."),
                .value = std::to_string(held) + " of " + std::to_string(all.size()) + " cases",
                .aim = "all",
                .holds = held == all.size(),
                .timed = true});
  if (!why.empty())
    report.text("Why not there? No method here but rkc covers more than 2 of the negative real axis an evaluation." +
                why + " rkc covers more, but starts again at every touch and slip.");
  report.table(
      "The paper's setting, pece at 0.1 ms: its error, and the methods that reach that error for the fewest "
      "evaluations "
      "and for the least CPU time, with their share of what the paper's setting needs.",
      {"case", "the paper's error", "fewest evaluations", "share", "least CPU time", "share"}, rows);
}

// What reaches the paper's own error for least, by evaluations and by CPU time.
std::vector<std::string> winners(const Found& f) {
  std::vector<std::string> names;
  const WorkPrecisionPoint* paper = paper_point(f);
  for (const auto cost : {&WorkPrecisionPoint::evaluations, &WorkPrecisionPoint::cpu}) {
    const std::string name = paper ? cheapest_at(f, paper->error_by(f.info.by_force), cost).method : "";
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

// The first screen: the paper's own error in each of its scenes, and what the best method needs for it.
void add_headline(Report& report, const std::vector<Found>& all) {
  std::string errors, shares;
  for (const Found& f : all) {
    const WorkPrecisionPoint* paper = paper_point(f);
    if (!f.info.by_force || !paper) continue;
    const double error = paper->error_by(true);
    const Cheapest best = cheapest_at(f, error, &WorkPrecisionPoint::evaluations);
    errors += (errors.empty() ? "" : ", ") + rounded(100 * error, 2) + " %";
    shares += (shares.empty() ? "" : ", ") + rounded(100 * best.cost / paper->evaluations, 2) + " % (" +
              spelt_out(best.method) + ")";
  }
  if (!errors.empty())
    report.headline(
        {.tile = "accurate",
         .value = errors,
         .text = "error of the force curve at the paper's setting: scene 1, then the 0.1 s of scenes 2 and 3 "
                 "that are charted. As good is the best method with " +
                 shares + " of the paper's evaluations, its computations of all forces."});
}

}  // namespace

Report work_precision(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("work_precision");
  std::vector<Found> all;
  for (const CaseInfo& info : work_precision_cases(numbers.quick())) all.push_back(found_in(numbers, info));
  Report report("Work against precision", "What does accuracy cost, and which method gives it for least?");
  add_paper(report, all);
  add_headline(report, all);
  report.text(
      "Error: of the force on the plate at equally spaced times, root mean square over that of the force, for the "
      "paper's scenes; of the positions of all bodies at the end, root mean square over that of how far each got "
      "from its start, for the others. Where contacts open or links tear, errors depend on how steps fall on "
      "events: then root mean squares over three neighbouring steps. Cost: evaluations of the right-hand side, "
      "which repeat to the digit, and CPU seconds on one thread, median and spread of three to nine runs. All "
      "methods run through the same loop, with the same jump after each step, samples, and no energy ledger. The "
      "jump evaluates the contacts, too. A method that begins its step with an evaluation there takes the jump's "
      "rates, and "
      "counts them; for the others the jump's evaluation is not counted, and is paid for in CPU time. +t: tears are "
      "located within the step; +e: so are touches, slips and forces held "
      "at zero, and steps behind a "
      "touch are graded; what that costs is counted. Tried with the own methods.");
  add_summary(report, all);
  add_gains(report, all);
  report.text(
      "In the charts below the paper's method and what needs least for the paper's own error are thick, the best of "
      "each "
      "family of Boost.Odeint grey. Crosses: the run failed, or its error is above 1. Star: the paper's setting. Bars: "
      "spread of the repeats. Below the dotted line the references do not distinguish errors: what is smaller is drawn "
      "on it.");
  for (const Found& f : all) {
    report.heading(capital(scene_words(f.info.name)) + ": " + without_scene(f.info.title));
    const WorkPrecisionPoint* paper = paper_point(f);
    report.figure(precision_chart(f.info, f.method_curves, floor_of(f), paper, winners(f)));
  }
  add_failures(report, all);
  add_references(report, all);
  add_predictability(report, all);
  return report;
}

}  // namespace furrow::validation
