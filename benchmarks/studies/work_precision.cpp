// Work against precision: every method on every case, by evaluations of the right-hand side and by CPU time.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <map>

#include "benchmarks/studies/precision_chart.h"
#include "benchmarks/studies/studies.h"
#include "benchmarks/studies/work_precision_curve.h"
#include "report/linearise.h"

namespace furrow::benchmarks {
namespace {

constexpr std::array<double, 3> targets{1e-2, 1e-4, 1e-6};
constexpr double paper_step = 1e-4;  // s, with pece

struct Found {
  CaseInfo info;
  Reference reference;
  Json foretold;
  std::vector<WorkPrecisionCurve> method_curves;
};

struct Cheapest {
  std::string method;
  double cost = NAN;
};

Cheapest cheapest_at(const Found& found, double error, double WorkPrecisionPoint::*cost) {
  Cheapest best;
  for (const WorkPrecisionCurve& method_curve : found.method_curves) {
    const double its = cost_at(method_curve, error, found.info.by_force, cost);
    if (its < best.cost || (std::isnan(best.cost) && !std::isnan(its))) best = {method_curve.name(), its};
  }
  return best;
}

const WorkPrecisionCurve& paper_curve(const Found& found) {
  return *std::find_if(found.method_curves.begin(), found.method_curves.end(),
                       [](const WorkPrecisionCurve& l) { return l.name() == "pece"; });
}

// The paper's method at the paper's step, or nothing if that failed.
const WorkPrecisionPoint* paper_point(const Found& found) {
  for (const WorkPrecisionPoint& p : paper_curve(found).points) {
    if (std::fabs(p.setting / paper_step - 1) < 1e-6 && p.failure.empty()) return &p;
  }
  return nullptr;
}

std::string shown(double value, const char* pattern = "%.2g") {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), pattern, value);
  return text.data();
}

Json number_or_dash(double value) { return std::isnan(value) ? Json("–") : Json(value); }

double floor_of(const Found& found) {
  const Error floor = found.reference.floor();
  return found.info.by_force ? floor.force : floor.place;
}

// ---- runs ----

class Scenes {
 public:
  explicit Scenes(const std::vector<CaseInfo>& wanted) {
    for (const CaseInfo& info : wanted) made_.try_emplace(info.name, info);
  }
  const Case& of(const CaseInfo& info) { return made_.at(info.name).get(); }

 private:
  std::map<std::string, LazyCase> made_;
};

std::vector<Found> all_runs(const Settings& settings, const std::vector<CaseInfo>& wanted) {
  Scenes scenes(wanted);
  std::vector<Task> tasks;
  for (const CaseInfo& info : wanted) {
    tasks.push_back({info.name + " references", [&scenes, info] { return reference_runs(info, scenes.of(info)); }});
    tasks.push_back({info.name + " nudged", [&scenes, info] { return predictability(info, scenes.of(info)); }});
  }
  const std::vector<Json> known = run_tasks("work_precision", settings, tasks);
  std::vector<Found> found;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (known[2 * k].contains("failed"))
      throw Divergence(wanted[k].name + ": " + known[2 * k]["failed"].get<std::string>());
    found.push_back({wanted[k], reference_from(known[2 * k]), known[2 * k + 1], {}});
  }
  tasks.clear();
  std::vector<std::pair<Found*, Variant>> to_measure;
  for (Found& f : found) {
    for (const MethodInfo& method : method_catalogue()) {
      for (const Locate locate : f.info.locate) {
        if (locate == Locate::none || method.family == "own") to_measure.push_back({&f, {method, locate}});
      }
    }
  }
  for (const auto& one : to_measure) {
    Found* f = one.first;
    const Variant variant = one.second;
    tasks.push_back(
        {f->info.name + " " + WorkPrecisionCurve{.method = variant.method.name, .locate = variant.locate}.name(),
         [&scenes, f, variant] { return json_of(measure_curve(variant, f->info, scenes.of(f->info), f->reference)); }});
  }
  Settings alone = settings;  // two at a time disturb each other's caches
  alone.jobs = 1;
  const std::vector<Json> results = run_tasks("work_precision", alone, tasks);
  for (std::size_t k = 0; k < results.size(); ++k) {
    const auto& [f, variant] = to_measure[k];
    WorkPrecisionCurve failed{
        .method = variant.method.name, .locate = variant.locate, .left_out = results[k].value("failed", "")};
    f->method_curves.push_back(results[k].contains("failed") ? failed : curve_from(results[k]));
  }
  return found;
}

// A line a point: the result is to be read in a diff.
Json lines_of(const WorkPrecisionCurve& method_curve) {
  Json lines = Json::array();
  for (const WorkPrecisionPoint& p : method_curve.points) {
    std::string line = shown(p.setting, "%.6g") + " " + shown(p.evaluations, "%.8g");
    for (const double value : {p.error.place, p.error.force, p.cpu, p.cpu_least, p.cpu_most})
      line += " " + shown(value, "%.4g");
    lines.push_back(
        p.failure.empty() ? line : shown(p.setting, "%.6g") + " " + shown(p.evaluations, "%.8g") + " " + p.failure);
  }
  return lines;
}

// ---- what is shown ----

void add_gains(Report& report, const std::vector<Found>& all) {
  std::vector<std::vector<Json>> rows;
  for (const Found& f : all) {
    const WorkPrecisionPoint* paper = paper_point(f);
    std::vector<std::pair<std::string, double>> asked;
    if (paper)
      asked.emplace_back(shown(paper->error_by(f.info.by_force)) + ", the paper's", paper->error_by(f.info.by_force));
    for (const double target : targets) asked.emplace_back(shown(target), target);
    for (const auto& [words, error] : asked) {
      std::vector<Json> row{f.info.name, words};
      for (const auto cost : {&WorkPrecisionPoint::evaluations, &WorkPrecisionPoint::cpu}) {
        const bool blind = error < floor_of(f);
        const Cheapest best = blind ? Cheapest{} : cheapest_at(f, error, cost);
        const double own = paper && error == paper->error_by(f.info.by_force)
                               ? paper->*cost
                               : cost_at(paper_curve(f), error, f.info.by_force, cost);
        row.emplace_back(blind ? "not resolved" : best.method.empty() ? "none" : best.method);
        row.push_back(number_or_dash(best.cost));
        row.push_back(number_or_dash(own / best.cost));
      }
      rows.push_back(row);
    }
  }
  report.table(
      "The cheapest method at an error, and how many times dearer the paper's method is there. At the paper's "
      "own error that is the paper's setting, pece at 1e-4 s. A method must keep the error with every finer "
      "setting; costs between two settings are read off the straight line in logarithms. Not resolved: below what the "
      "references can distinguish.",
      {"scene", "error", "fewest evaluations", "evaluations", "gain", "least CPU", "CPU [s]", "gain"}, rows);
}

void add_references(Report& report, const std::vector<Found>& all) {
  std::vector<std::vector<Json>> rows;
  for (const Found& f : all) {
    rows.push_back({f.info.name, f.info.title, f.info.by_force ? "force curve" : "positions", f.info.reference_step,
                    f.reference.other, f.reference.disagreement.place, f.reference.disagreement.force, floor_of(f),
                    f.reference.outcome.torn});
  }
  report.table(
      "References: rk4 at a short step, and a method that shares nothing with it. The charts end where the two "
      "differ by a tenth of the error.",
      {"scene", "what happens", "judged by", "step of rk4 [s]", "the other", "difference, positions",
       "difference, force curve", "smallest error shown", "links torn"},
      rows);
}

void add_predictability(Report& report, const std::vector<Found>& all) {
  std::vector<std::vector<Json>> rows;
  const auto until = [](const Json& time) { return time.is_null() ? Json("never") : time; };
  for (const Found& f : all) {
    if (f.foretold.contains("failed")) {
      rows.push_back({f.info.name, "failed: " + f.foretold["failed"].get<std::string>()});
      continue;
    }
    const Json& t = f.foretold["until"];
    rows.push_back({f.info.name, f.foretold["watched"], f.foretold["grown"], until(t[0]), until(t[1]), until(t[2])});
  }
  report.table(
      "How long the scenes can be foretold: two runs whose starts differ by 1e-12 of each position (pece at "
      "2.5e-5 s), by how much that has grown at the end of the chart, and when they differ by more than a "
      "fraction of the way that the bodies have gone.",
      {"scene", "watched [s]", "grown, times", "1e-9 apart [s]", "1e-6 apart [s]", "1e-3 apart [s]"}, rows);
}

// Why no method with a bounded stable interval can be much cheaper: of the fixed-step methods Euler's covers most of
// the negative real axis an evaluation, 2 (see the stability study; Hairer and Wanner, Solving Ordinary Differential
// Equations II, section IV.2).
void add_bound(Report& report, const Found& f, double papers) {
  const Case scene = make_case(f.info);
  double fastest = 0;  // 1/s
  for (const std::complex<double> value : spectrum(linearise(scene.system, scene.span.start, scene.y)))
    fastest = std::max(fastest, -value.real());
  const double least = fastest * (scene.span.end() - scene.span.start) / 2;
  report.text(f.info.name + ": why not. The fastest decay where the chart begins is " + shown(fastest) +
              " 1/s, by the spectrum. No method here but rkc covers more than 2 of the negative real axis an "
              "evaluation, so that the others need " +
              shown(least) + " evaluations to stay stable at all, " + shown(100 * least / papers, "%.0f") +
              " % of the paper's. rkc covers more, but starts again at every touch and slip.");
}

void add_paper(Report& report, const Found& f) {
  const WorkPrecisionPoint* paper = paper_point(f);
  if (!paper) {
    report.claim(f.info.name + ": the paper's setting comes to the end", false);
    return;
  }
  const double error = paper->error_by(f.info.by_force);
  const Cheapest by_count = cheapest_at(f, error, &WorkPrecisionPoint::evaluations);
  const Cheapest by_cpu = cheapest_at(f, error, &WorkPrecisionPoint::cpu);
  const double count = by_count.cost / paper->evaluations;
  const double cpu = by_cpu.cost / paper->cpu;
  const bool third = count <= 1.0 / 3 && cpu <= 1.0 / 3;
  report.claim(f.info.name + ": the paper's error of " + shown(error) + " is reached by " + by_count.method + " at " +
                   shown(100 * count, "%.1f") + " % of its evaluations, by " + by_cpu.method + " in " +
                   shown(100 * cpu, "%.1f") + " % of its CPU time: no more than a third",
               third);
  if (!third) add_bound(report, f, paper->evaluations);
}

// By method the finest setting that failed, and one failure in full.
void add_failures(Report& report, const Found& f) {
  std::string left_out, failed, example;
  for (const WorkPrecisionCurve& l : f.method_curves) {
    if (!l.left_out.empty()) left_out += " " + l.name() + " is left out: " + l.left_out + ".";
    const auto finest = std::find_if(l.points.rbegin(), l.points.rend(),
                                     [](const WorkPrecisionPoint& p) { return !p.failure.empty(); });
    if (finest == l.points.rend()) continue;
    failed += (failed.empty() ? "" : ", ") + l.name() + " " + shown(finest->setting);
    if (example.empty()) example = l.name() + " at " + shown(finest->setting) + ": " + finest->failure;
  }
  if (!failed.empty())
    report.text("Finest step (of controlled methods: tolerance) that failed: " + failed + ". The first of them, " +
                example + ".");
  if (!left_out.empty()) report.text("Not run:" + left_out);
}

}  // namespace

Json work_precision(const Settings& settings) {
  std::vector<CaseInfo> wanted = cases();
  if (settings.quick) {
    std::erase_if(wanted, [](const CaseInfo& info) { return info.big; });
    for (CaseInfo& info : wanted) info.finest = std::min(8 * info.finest, paper_step);
  }
  const std::vector<Found> all = all_runs(settings, wanted);
  Report report("Work against precision", "What does accuracy cost, and which method gives it for least?");
  for (const Found& f : all) add_paper(report, f);
  report.text(
      "Error: of the force on the plate at equally spaced times, root mean square over that of the force, for the "
      "paper's scenes; of the positions of all bodies at the end, root mean square over that of how far each got "
      "from its start, for the others. Where contacts open or links tear, errors depend on how steps fall on "
      "events: then root mean squares over three neighbouring steps. Cost: evaluations of the right-hand side, "
      "which repeat to the digit, and CPU seconds on one thread, median and spread of three to nine runs. All "
      "methods run through the same loop, with the same jump after each step, samples, and no energy ledger. The "
      "jump evaluates the contacts once more and is not counted among the evaluations: a method with many cheap "
      "steps pays for it in CPU time. +t: tears are located within the step; +e: so are touches, slips and forces held "
      "at zero, and steps behind a "
      "touch are graded; what that costs is counted. Tried with the own methods.");
  add_gains(report, all);
  for (const Found& f : all) {
    report.heading(f.info.name + ": " + f.info.title);
    const WorkPrecisionPoint* paper = paper_point(f);
    report.figure(precision_chart(f.info, f.method_curves, floor_of(f), paper));
    add_failures(report, f);
  }
  add_references(report, all);
  add_predictability(report, all);
  Json data = {{"columns", "setting evaluations position_error force_error cpu cpu_least cpu_most, or failure"}};
  for (const Found& f : all) {
    for (const WorkPrecisionCurve& l : f.method_curves) data[f.info.name][l.name()] = lines_of(l);
  }
  return report.data(std::move(data)).json();
}

}  // namespace furrow::benchmarks
