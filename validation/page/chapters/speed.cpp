// How fast is furrow beside other programs and beside the machine's limit? All times were taken by scripts/rivals,
// scripts/track, scripts/scale and scripts/beyond.
#include <map>
#include <vector>

#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/speed_parts.h"

namespace furrow::validation {
namespace {

// Google Benchmark's report of the kernel with vectors of one width; null if it has not been measured.
Json kernel_report(const Numbers& numbers, const std::string& width) {
  return measured(numbers, "kernel_" + width + ".json");
}

// Median CPU time of a contact, by what is measured. ns
std::map<std::string, double> contact_times(const Json& report) {
  std::map<std::string, double> times;
  if (report.is_null()) return times;
  for (const Json& b : report.at("benchmarks")) {
    const std::string name = b.at("run_name");
    if (b.value("aggregate_name", "") == "median")
      times[name.substr(0, name.find('/'))] = 1e9 * b.at("s/contact").get<double>();
  }
  return times;
}

// What the arithmetic of a contact takes at least, with the widest vectors that have been measured.
std::string widest_bound(const Numbers& numbers) {
  for (const std::string width : {"avx512", "avx2", "none"}) {
    const auto times = contact_times(kernel_report(numbers, width));
    if (times.contains("bound"))
      return " The arithmetic of a contact takes at least " + rounded(times.at("bound"), 3) +
             " ns there (vectors: " + width + "; see below).";
  }
  return {};
}

double ratio_of(const Json& program) { return program.at("ratio")[1].get<double>(); }

// "LAMMPS, granular (the same law, 1 evaluation a step)"
std::string law_and_evaluations(const Json& program) {
  const std::string count = program.at("evaluations").dump();
  return program.at("run_name").get<std::string>() + " (" + program.at("label").get<std::string>() + ", " + count +
         (count == "1" ? " evaluation" : " evaluations") + " a step)";
}

// The first screen. same: null if no program of the same law agrees.
void add_headlines(Report& report, const Json& pece, const Json& best, const Json* same) {
  report.headline({.tile = "fast",
                   .value = rounded(pece.at("cpu_time").get<double>(), 3) + " µs a step",
                   .text = "of the paper's method, two evaluations, in a bed of 230 discs on one core.",
                   .numbers = {"rivals.json"}});
  const Json& first = same ? *same : best;
  std::string text = "takes " + law_and_evaluations(first) + " in that bed as furrow with one evaluation; " +
                     rounded(ratio_of(first) / ratio_of(pece), 3) +
                     " times as long as furrow by the paper's method, with two.";
  if (same && same != &best)
    text += " The fastest has another law: " + law_and_evaluations(best) + ": " + rounded(ratio_of(best), 3) + " and " +
            rounded(ratio_of(best) / ratio_of(pece), 3) + " times.";
  report.headline({.tile = "engines",
                   .value = rounded(ratio_of(first), 3) + " times as long",
                   .text = text,
                   .numbers = {"rivals.json"}});
}

void add_rivals(Report& report, const Numbers& numbers, const Json& rivals) {
  std::vector<std::vector<Json>> rows;
  Json dots = Json::array();
  // Of those that agree, furrow left out: the fastest, and the fastest of the same contact law.
  const Json *pece = nullptr, *best = nullptr, *same = nullptr;
  for (const Json& program : rivals.at("benchmarks")) {
    const bool ran = !program.value("error_occurred", false);
    if (ran && program.value("aggregate_name", "") != "median") continue;
    const Json& name = program.at("run_name");
    const bool own = name.get<std::string>().rfind("furrow", 0) == 0, agrees = program.value("agrees", false);
    rows.push_back({name, program.at("label"), ran ? program.at("cpu_time") : Json("failed"),
                    ran ? Json(spread(program.at("ratio"))) : Json(),
                    ran ? Json(1e9 * program.at("s/contact").get<double>()) : Json(),
                    program.contains("height") ? Json(rounded(program["height"].get<double>(), 4)) : Json(),
                    program.value("push", Json()),
                    agrees                                ? "yes"
                    : program.value("agrees_early", true) ? "no: not ranked"
                                                          : "no, from the start: not ranked"});
    if (!ran) continue;
    const Json& ratio = program.at("ratio");
    dots.push_back({ratio[0], ratio[1], ratio[2], own ? 0 : agrees ? 1 : 2, name});
    if (own && program.at("evaluations") == 2) pece = &program;
    if (!own && agrees && (best == nullptr || ratio[1] < (*best)["ratio"][1])) best = &program;
    const bool same_law = program.at("label").get<std::string>().rfind("the same law", 0) == 0;
    if (!own && agrees && same_law && (same == nullptr || ratio[1] < (*same)["ratio"][1])) same = &program;
  }
  const Json& context = rivals.at("context");
  report.heading("Other programs on the same scene");
  report.text("Scene 2 with what every program can express: " + context.at("discs").dump() +
              " discs that furrow has settled, E = 2e7 Pa, restitution 0.5, friction with history, no rolling, steps "
              "of 0.1 ms. A program agrees if its push on the plate without friction, before the bed is chaotic, goes "
              "to furrow's with "
              "the order of the step, and if after half a second at rest its bed is as high as furrow's within " +
              rounded(1e3 * context.at("height_tolerance").get<double>(), 3) +
              " mm, and its mean push on the plate is " + rounded(context.at("push").get<double>(), 3) + " N within " +
              rounded(context.at("push_tolerance").get<double>(), 3) +
              " N, four standard deviations of furrow's own runs from starts that differ by 1e-9 m. Each program is "
              "run in turn with the others, on one thread of " +
              context.at("machine").get<std::string>() +
              "; what it needs to start is taken off. Time a contact is that of a step over its evaluations and the " +
              rounded(context.at("contacts").get<double>(), 3) + " contacts that touch on average." +
              widest_bound(numbers));
  report.table(
      "CPU time of a step over that of furrow with one evaluation a step: median and its 95 % interval",
      {"program", "contact law", "µs a step", "CPU time, ratio", "ns a contact", "height [m]", "push [N]", "agrees"},
      rows);
  report.figure(
      {.name = "speed_rivals",
       .script = "speed.gp",
       .caption = "CPU time of a step over that of furrow with one evaluation a step; lines are 95 % intervals of the "
                  "median. Open marks: programs that do not agree.",
       .description = "CPU time of other programs on the same scene, as ratio to furrow",
       .variables = {{"count", dots.size()}},
       .blocks = {{"dots", dots}}});
  if (best == nullptr || pece == nullptr) {
    report.claim({.text = "Rivals that agree with furrow on the physics.", .value = "none", .aim = "one or more"});
    return;
  }
  add_headlines(report, *pece, *best, same);
  const double over = (*best)["ratio"][1].get<double>() / pece->at("ratio")[1].get<double>();
  report.claim({.text = "CPU time of the fastest rival that agrees, " + law_and_evaluations(*best) +
                        ", over that of furrow with one evaluation a step.",
                .value = rounded((*best)["ratio"][1].get<double>(), 3) + " times",
                .aim = "more than 1",
                .holds = (*best)["ratio"][0].get<double>() > 1,
                .timed = true,
                .numbers = {"rivals.json"}});
  report.claim({.text = "CPU time of the fastest rival that agrees, " + law_and_evaluations(*best) +
                        ", over that of the paper's method in furrow, which has two evaluations a step.",
                .value = rounded(over, 3) + " times",
                .aim = "at least 4",
                .holds = over >= 4,
                .timed = true,
                .numbers = {"rivals.json"}});
}

void add_limit(Report& report, const Numbers& numbers) {
  std::vector<std::vector<Json>> rows;
  double all_over = 0;
  std::string machines;
  std::vector<std::string> read;
  for (const char* width : {"none", "avx2", "avx512"}) {
    const Json measured = kernel_report(numbers, width);
    const auto times = contact_times(measured);
    if (times.size() < 3) continue;
    name_also(machines, measured);
    read = {std::string("kernel_") + width + ".json"};  // the widest vectors make the claim
    const double bound = times.at("bound"), law = times.at("law"), whole = times.at("pairs_law_and_sums");
    all_over = whole / bound;
    rows.push_back({width, bound, law, whole, law / bound, whole / bound});
  }
  if (rows.empty()) return not_measured(report, "the machine's limit", "scripts/rivals");
  report.heading("How close to the machine's limit");
  report.text(
      "How fast could any program be here? A contact cannot do without two square roots, one division and some sixty "
      "other operations: a loop over these alone, in the first-level cache, is the machine's limit. Beside it the "
      "kernel's own loops: the contact law, from overlap and velocities to forces and torques, and all of a contact's "
      "work, with the gathering of pairs of discs and their springs before it and the summing of forces behind it, "
      "which no vector speeds up as much. The law alone lies below the limit, for the distance, with a root and the "
      "division, is found while pairs are gathered.");
  report.table("CPU time of a contact in ns, median of nine, by the vectors that the kernel may use; " + machines,
               {"vectors", "limit [ns]", "law [ns]", "all [ns]", "law over limit", "all over limit"}, rows);
  report.claim({.text = "With the widest vectors: time of all of a contact's work over the machine's limit.",
                .value = rounded(all_over, 3) + " times",
                .aim = "at most 2.5",
                .holds = all_over <= 2.5,
                .timed = true,
                .numbers = read});
}

}  // namespace

Report speed(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("speed");
  Report report("Speed",
                "How fast is furrow beside other programs on the same scene and beside the machine's limit, where does "
                "the time go, up to how many discs, what lies beyond one machine, and from commit to commit?");
  const Json rivals = measured(numbers, "rivals.json");
  if (rivals.is_null()) {
    not_measured(report, "other programs on the same scene", "scripts/rivals");
  } else {
    add_rivals(report, numbers, rivals);
  }
  add_bonds(report, numbers);
  add_limit(report, numbers);
  add_profile(report, numbers);
  add_scale(report, numbers);
  add_beyond(report, numbers);
  add_tracking(report, numbers);
  return report;
}

}  // namespace furrow::validation
