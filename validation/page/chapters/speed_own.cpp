// Of furrow alone: where the instructions go, and how many discs.
#include <map>
#include <set>

#include "validation/page/chapters/speed_parts.h"

namespace furrow::validation {
Json measured(const Numbers& numbers, const std::string& file) {
  const Result* result = numbers.find(file);
  return result ? result->value : Json();
}

namespace {

// The processor it was measured on, or its clock where the report has no name.
std::string machine_of(const Json& google) {
  const Json& context = google.at("context");
  if (context.contains("machine")) return context["machine"];
  return context.at("num_cpus").dump() + " processors of " + context.at("mhz_per_cpu").dump() + " MHz";
}

}  // namespace

void name_also(std::string& machines, const Json& google) {
  const std::string machine = machine_of(google);
  if (machines.find(machine) == std::string::npos) machines += (machines.empty() ? "" : ", ") + machine;
}

std::string spread(const Json& three) {
  const auto part = [&](int k) { return rounded(three.at(k).get<double>(), 3); };
  return part(1) + " [" + part(0) + ", " + part(2) + "]";
}

void not_measured(Report& report, const std::string& what, const std::string& by) {
  report.claim({.text = what + ", by " + by + ".", .value = "not measured", .aim = "measured"});
}

// ---- where the instructions go: scripts/track --profile ----

void add_profile(Report& report, const Numbers& numbers) {
  const Json profile = measured(numbers, "profile.json");
  if (profile.is_null()) return not_measured(report, "where the instructions go", "scripts/track --profile");
  const Json& scenes = profile.at("scenes");
  std::vector<std::vector<Json>> rows;
  Json dots = Json::array();
  for (const auto& [part, unused] : scenes.at(0).at("parts").items()) {
    std::vector<Json> row{part};
    Json dot = Json::array();
    for (const Json& scene : scenes) {
      const double count = scene.at("parts").at(part);
      row.emplace_back(count / scene.at("steps").get<double>());
      dot.push_back(100 * count / scene.at("instructions").get<double>());
    }
    dot.push_back(part);
    dots.push_back(dot);
    rows.push_back(row);
  }
  std::vector<Json> whole{"all"};
  for (const Json& scene : scenes) whole.push_back(scene.at("a_step"));
  rows.push_back(whole);
  const auto a_disc = [&](int k) { return rounded(scenes.at(k).at("a_disc_and_evaluation").get<double>(), 3); };
  report.heading("Where the instructions go");
  report.text(
      "The paper's three scenes from a settled bed to their end, step for step with their ledger and files, counted by "
      "callgrind (" +
      profile.at("counted_with").get<std::string>() +
      "). Instructions are not time: a division weighs as much as a sum. What the C library does is counted where it "
      "was called. A step evaluates the contacts twice, once of them within the jump map, whose rates the next step "
      "takes over; both stand under pairs, law and sums. A disc and evaluation takes " +
      a_disc(1) + " instructions in scene 2, " + a_disc(2) + " in scene 3.");
  report.figure({.name = "speed_profile",
                 .script = "speed_profile.gp",
                 .caption = "Share of a step's instructions by part of the solver.",
                 .description = "Share of instructions by part of the solver for the three scenes",
                 .variables = {{"count", dots.size()}},
                 .blocks = {{"dots", dots}}});
  report.table("Instructions a step, by part of the solver", {"part", "scene 1", "scene 2", "scene 3"}, rows);
}

// ---- how many discs: scripts/scale ----

namespace {

// Google Benchmark's entries by what is measured, those with two threads as "... by two": the median where there are
// several.
std::map<std::string, Json> entries_of(const Json& google) {
  std::map<std::string, Json> entries;
  if (google.is_null()) return entries;
  for (const Json& entry : google.at("benchmarks")) {
    const std::string run = entry.at("run_name");
    const bool by_two = run.find("/workers:2/") != std::string::npos;
    const std::string name = run.substr(0, run.find('/')) + (by_two ? " by two" : "");
    if (entry.value("aggregate_name", "median") == "median" && !entry.value("error_occurred", false))
      entries[name] = entry;
  }
  return entries;
}

Json value_of(const std::map<std::string, Json>& entries, const std::string& name, const char* key, double scale) {
  const auto found = entries.find(name);
  if (found == entries.end() || !found->second.contains(key)) return {};
  return found->second[key].get<double>() * scale;
}

// How many times as fast two threads are, by the clock.
Json gain_of(const std::map<std::string, Json>& entries, const std::string& name) {
  const Json one = value_of(entries, name, "real_time", 1), two = value_of(entries, name + " by two", "real_time", 1);
  return one.is_number() && two.is_number() ? Json(one.get<double>() / two.get<double>()) : Json();
}

}  // namespace

void add_scale(Report& report, const Numbers& numbers) {
  std::vector<std::vector<Json>> times, makings;
  std::string timed_on, made_on;
  double least = 0, most = 0;  // ns a disc
  Json gain;                   // of two threads, in the largest bed
  for (const char* discs : {"2300", "23000", "230000", "1000000"}) {
    const Json timing = measured(numbers, std::string("scale_") + discs + ".json");
    const auto timed = entries_of(timing);
    const auto random = entries_of(measured(numbers, std::string("scale_random_") + discs + ".json"));
    if (!timed.empty()) {
      name_also(timed_on, timing);
      const Json evaluation = value_of(timed, "evaluation", "s/disc", 1e9);
      const Json step = value_of(timed, "step", "s/disc", 1e9);
      gain = gain_of(timed, "evaluation");
      times.push_back({value_of(timed, "evaluation", "discs", 1), evaluation,
                       value_of(random, "evaluation_in_random_order", "s/disc", 1e9),
                       value_of(timed, "evaluation_with_new_list", "s/disc", 1e9), step,
                       value_of(timed, "step", "per_second", 1), gain, gain_of(timed, "step"),
                       value_of(timed, "step", "peak_bytes/disc", 1)});
      if (evaluation.is_number()) {
        most = evaluation;
        if (least == 0) least = most;
      }
    }
    const Json making = measured(numbers, std::string("scale_making_") + discs + ".json");
    const auto made = entries_of(making);
    if (made.empty()) continue;
    name_also(made_on, making);
    const auto settling = [&](const char* key, double scale) { return value_of(made, "settling by two", key, scale); };
    makings.push_back({value_of(made, "packing", "discs", 1), value_of(made, "packing", "cpu_time", 1e-3),
                       settling("cpu_time", 1e-3), settling("real_time", 1e-3), settling("model_seconds", 1),
                       settling("steps", 1)});
  }
  if (times.size() < 4) not_measured(report, "all four beds", "scripts/scale");
  if (times.empty()) return;
  report.heading("How many discs");
  report.text(
      "The bed of scene 2, settled and put side by side, with friction and rolling, without the energy "
      "ledger; one thread, but for what is said of two; beds of no more than 4,096 discs do not share a step. A step "
      "is one of the paper's method, with two evaluations and the jump map. Memory is the most that "
      "the process has held, over its discs: for few discs it is that of the program. Numbered at random: "
      "without regard to where they lie; the program numbers packings of more than 4,096 discs by place.");
  report.table("CPU time of a disc [ns] and its memory, median of several runs on " + timed_on,
               {"discs", "evaluation", "numbered at random", "with a new neighbour list", "step", "steps a second",
                "two threads: evaluation, times as fast", "step, times as fast", "memory [bytes]"},
               times);
  if (!makings.empty()) {
    report.table(
        "Until the program has made the bed by itself: packed at random on one thread, then settled on two until for "
        "0.1 s no more than one disc in a thousand moved faster than 50 mm/s; " +
            made_on,
        {"discs", "packing, CPU [s]", "settling, CPU [s]", "by the clock [s]", "settled after [s of the model]",
         "steps"},
        makings);
  }
  if (times.size() < 4) return;
  report.claim({.text = "From cache to memory: time of a disc in an evaluation of a million over that in one of 2,300.",
                .value = rounded(most / least, 2) + " times",
                .aim = "at most 1.5",
                .holds = most / least <= 1.5,
                .timed = true,
                .numbers = {"scale_2300.json", "scale_1000000.json"}});
  report.claim({.text = "Disc-evaluations a second of a million discs on one thread.",
                .value = rounded(1e3 / most, 3) + " million",
                .aim = "at least 20 million",
                .holds = 1e3 / most >= 20,
                .timed = true,
                .numbers = {"scale_1000000.json"}});
  if (gain.is_number())
    report.claim({.text = "Two threads in an evaluation of a million discs, times as fast as one.",
                  .value = rounded(gain.get<double>(), 3) + " times",
                  .aim = "at least 1.8",
                  .holds = gain.get<double>() >= 1.8,
                  .timed = true,
                  .numbers = {"scale_1000000.json"}});
}

}  // namespace furrow::validation
