#include <cstdio>
#include <fstream>
#include <map>
#include <set>

#include "benchmarks/studies/speed.h"

namespace furrow::benchmarks {
namespace {

Json read_if_there(const std::string& name) {
  std::ifstream file(speed_results / name);
  return file ? Json::parse(file) : Json();
}

}  // namespace

std::string in_digits(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
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
  const auto part = [&](int k) { return in_digits(three.at(k).get<double>(), 3); };
  return part(1) + " [" + part(0) + ", " + part(2) + "]";
}

void not_measured(Report& report, const std::string& what, const std::string& by) {
  report.claim("Measured: " + what + ", by " + by + ".", false);
}

// ---- where the instructions go: scripts/track --profile ----

void add_profile(Report& report) {
  const Json profile = read_if_there("profile.json");
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
  const auto a_disc = [&](int k) { return in_digits(scenes.at(k).at("a_disc_and_evaluation").get<double>(), 3); };
  report.heading("Where the instructions go");
  report.text(
      "The paper's three scenes from a settled bed to their end, step for step with their ledger and files, counted by "
      "callgrind (" +
      profile.at("counted_with").get<std::string>() +
      "). Instructions are not time: a division weighs as much as a sum. What the C library does is counted where it "
      "was called. A step evaluates the contacts twice, once of them within the jump map, whose rates the next step "
      "takes over; both stand under pairs, law and sums. A disc and evaluation takes " +
      a_disc(1) + " instructions in the second scene, " + a_disc(2) + " in the third.");
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

void add_scale(Report& report) {
  std::vector<std::vector<Json>> times, makings;
  std::string timed_on, made_on;
  double least = 0, most = 0;  // ns a disc
  Json gain;                   // of two threads, in the largest bed
  for (const char* discs : {"2300", "23000", "230000", "1000000"}) {
    const Json timing = read_if_there(std::string("scale_") + discs + ".json");
    const auto timed = entries_of(timing);
    const auto random = entries_of(read_if_there(std::string("scale_random_") + discs + ".json"));
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
    const Json making = read_if_there(std::string("scale_making_") + discs + ".json");
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
      "The bed of the second scene, settled and put side by side, with friction and rolling, without the energy "
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
  report.claim(
      "From cache to memory the time of a disc stays within a factor 1.5: an evaluation of a million discs takes " +
          in_digits(most / least, 2) + " times as long a disc as one of 2,300.",
      most / least <= 1.5);
  report.claim("A million discs: at least 20 million disc-evaluations a second on one thread, " +
                   in_digits(1e3 / most, 3) + " million.",
               1e3 / most >= 20);
  if (gain.is_number())
    report.claim("Two threads are at least 1.8 times as fast in an evaluation of a million discs: " +
                     in_digits(gain.get<double>(), 3) + " times.",
                 gain.get<double>() >= 1.8);
}

// ---- from commit to commit: scripts/track ----

namespace {

const Json* kernel_of(const Json& line, const std::string& name) {
  for (const Json& kernel : line.at("benchmarks")) {
    if (kernel.at("run_name") == name) return &kernel;
  }
  return nullptr;
}

// Instructions of each kernel over those of its first line, in percent, commit by commit.
Figure trend_of(const std::vector<Json>& lines) {
  Figure figure{.name = "speed_trend",
                .script = "speed_trend.gp",
                .caption =
                    "Instructions of each kernel, commit by commit, over those of the first commit followed. Dashed: 2 "
                    "%, what CI lets pass without a reason.",
                .description = "Change of instruction counts of each kernel from commit to commit"};
  Json points = Json::array();
  int panel = 0;
  for (const Json& kernel : lines.back().at("benchmarks")) {
    const std::string name = kernel.at("run_name");
    figure.variables["kernel_" + std::to_string(panel)] = name;
    double first = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const Json* entry = kernel_of(lines[k], name);
      if (entry == nullptr) continue;
      const double count = entry->at("instructions");
      if (first == 0) first = count;
      points.push_back({panel, k, 100 * (count / first - 1)});
    }
    ++panel;
  }
  figure.variables["panels"] = panel;
  figure.variables["commits"] = lines.size();
  figure.variables["first_commit"] = lines.front().at("commit");
  figure.variables["last_commit"] = lines.back().at("commit");
  figure.blocks["points"] = points;
  return figure;
}

}  // namespace

void add_tracking(Report& report) {
  std::ifstream file(speed_results / "track.jsonl");
  std::vector<Json> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(Json::parse(line));
  if (lines.empty()) return not_measured(report, "any commit", "scripts/track");
  constexpr std::size_t shown = 4;  // commits in the table
  const Json& last = lines.back();
  std::vector<std::string> head{"kernel"};
  for (std::size_t k = lines.size() - std::min(shown, lines.size()); k < lines.size(); ++k)
    head.push_back(lines[k].at("commit").get<std::string>() + " [M]");
  head.insert(head.end(), {"ns a call", "over its base", "noise floor [%]", "error [m]", "verdict"});
  std::vector<std::vector<Json>> rows;
  std::set<std::string> verdicts;
  for (const Json& kernel : last.at("benchmarks")) {
    const std::string name = kernel.at("run_name");
    std::vector<Json> row{name};
    for (std::size_t k = lines.size() - std::min(shown, lines.size()); k < lines.size(); ++k) {
      const Json* entry = kernel_of(lines[k], name);
      row.push_back(entry ? Json(entry->at("instructions").get<double>() / 1e6) : Json());
    }
    const bool compared = kernel.contains("ratio");
    row.push_back(kernel.at("cpu_time"));
    row.push_back(compared ? Json(spread(kernel["ratio"])) : Json());
    row.push_back(compared ? Json(100 * kernel["noise"].get<double>()) : Json());
    row.emplace_back(kernel.at("error").is_null() ? "-" : in_digits(kernel["error"], 2));
    row.push_back(kernel.at("verdict"));
    rows.push_back(row);
  }
  report.heading("From commit to commit");
  report.text(
      "Fixed kernels, built for x86-64-v3. Each line of benchmarks/results/track.jsonl is one commit on one machine, "
      "run in turn with its base commit: the ratio of CPU time is the median and its 95 % interval, the noise floor is "
      "how far the base differs from itself. Faster or slower is said only where the whole interval lies beyond "
      "that floor. The answer of each kernel is the same to the bit, or it is not compared. Last: " +
      last.at("commit").get<std::string>() + " over " + last.at("base").get<std::string>() + ", " +
      last.at("context").at("machine").get<std::string>() + ".");
  if (lines.size() > 1) report.figure(trend_of(lines));
  report.table(
      "Millions of instructions of each kernel by commit, counted by callgrind; of the last commit the time of a call, "
      "that over its base, and what the method got wrong",
      head, rows);
}

}  // namespace furrow::benchmarks
