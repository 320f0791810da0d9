// What scripts/rivals and scripts/track have measured, put together for the page. Nothing is measured here: times are
// taken by these two alone, in turn with what they are compared with.
#include <cstdio>
#include <fstream>
#include <map>

#include "output/files.h"
#include "studies/catalogue.h"

namespace furrow::studies {
namespace {

namespace fs = std::filesystem;

const fs::path results = "benchmarks/results";

std::ifstream opened(const char* name, const char* made_by) {
  std::ifstream file(results / name);
  if (!file) throw FileError("no " + (results / name).string() + " in this directory; " + made_by + " makes it");
  return file;
}

std::string rounded(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string interval(const Json& three) {
  const auto part = [&](int k) { return rounded(three.at(k).get<double>(), 3); };
  return part(1) + " [" + part(0) + ", " + part(2) + "]";
}

void add_rivals(Report& report, const Json& rivals) {
  std::vector<std::vector<Json>> rows;
  Json dots = Json::array();
  const Json* best = nullptr;  // of those that agree, furrow apart
  for (const Json& program : rivals.at("programs")) {
    const bool ran = program.contains("ratio"), own = program.at("name").get<std::string>().rfind("furrow", 0) == 0;
    const bool agrees = program.value("agrees", false);
    rows.push_back({program.at("name"), program.at("law"), ran ? Json(interval(program["ratio"])) : Json("failed"),
                    ran ? program["nanoseconds_a_contact"] : Json(), program.value("height", Json()),
                    program.value("push", Json()), agrees ? "yes" : "no: not ranked"});
    if (!ran) continue;
    const Json& ratio = program["ratio"];
    dots.push_back({ratio[0], ratio[1], ratio[2], own ? 0 : agrees ? 1 : 2, program["name"]});
    if (!own && agrees && (best == nullptr || ratio[1] < (*best)["ratio"][1])) best = &program;
  }
  report.heading("Other programs on the same scene");
  report.text("The second scene with what every program can express: " + rivals.at("discs").dump() +
              " discs that furrow has settled, E = 2e7 Pa, restitution 0.5, friction with history, no rolling, steps "
              "of 1e-4 s. A "
              "program agrees if after half a second at rest its bed is as high as furrow's within " +
              rounded(1e3 * rivals.at("height_tolerance").get<double>(), 3) +
              " mm, and its mean push on the plate is " + rounded(rivals.at("push").get<double>(), 3) + " N within " +
              rounded(rivals.at("push_tolerance").get<double>(), 3) +
              " N, four standard deviations of furrow's own runs from starts that differ by 1e-9 m.");
  report.table("CPU time of a step over that of furrow with one evaluation a step: median and its 95 % interval",
               {"program", "contact law", "CPU time, ratio", "ns a contact", "height [m]", "push [N]", "agrees"}, rows);
  report.figure(
      {.name = "speed_rivals",
       .script = "speed.gp",
       .caption = "CPU time of a step over that of furrow with one evaluation a step; lines are 95 % intervals of the "
                  "median. Open marks: programs that do not agree.",
       .description = "CPU time of other programs on the same scene, as ratio to furrow",
       .variables = {{"count", dots.size()}},
       .blocks = {{"dots", dots}}});
  if (best == nullptr) {
    report.claim("A rival agrees with furrow on the physics.", false);
    return;
  }
  const Json& pece = rivals.at("programs")[1];
  const double over = (*best)["ratio"][1].get<double>() / pece.at("ratio")[1].get<double>();
  report.claim("The fastest rival that agrees, " + (*best)["name"].get<std::string>() + ", takes " +
                   rounded((*best)["ratio"][1].get<double>(), 3) +
                   " times the CPU time of furrow with one evaluation a step, and " + rounded(over, 3) +
                   " times that of the paper's method with its two.",
               (*best)["ratio"][0].get<double>() > 1);
  report.claim(
      "The paper's method, with two evaluations a step, takes a quarter of the CPU time of the fastest rival or less.",
      over >= 4);
}

// Median CPU time of a contact in Google Benchmark's report of one vector width, by what is measured. ns
std::map<std::string, double> contact_times(const fs::path& file) {
  std::ifstream stream(file);
  std::map<std::string, double> times;
  if (!stream) return times;
  const Json report = Json::parse(stream);
  for (const Json& b : report.at("benchmarks")) {
    const std::string name = b.at("run_name");
    if (b.value("aggregate_name", "") == "median")
      times[name.substr(0, name.find('/'))] = 1e9 * b.at("s/contact").get<double>();
  }
  return times;
}

void add_limit(Report& report) {
  std::vector<std::vector<Json>> rows;
  double over = 0;
  for (const char* width : {"none", "avx2", "avx512"}) {
    const auto times = contact_times(results / (std::string("kernel_") + width + ".json"));
    if (times.size() < 3) continue;
    const double bound = times.at("bound"), law = times.at("law"), whole = times.at("pairs_law_and_sums");
    over = law / bound;
    rows.push_back({width, bound, law, whole, law / bound, whole / bound});
  }
  if (rows.empty()) return;
  report.heading("How close to the machine's limit");
  report.text(
      "How fast could any program be here? A contact cannot do without two square roots, one division and some sixty "
      "other operations: a loop over these alone, in the first-level cache, is the machine's limit. Beside it the "
      "kernel's own loops: the contact law, and all of a contact's work, with the gathering of pairs of discs before "
      "it and the summing of forces behind it, which no vector speeds up as much.");
  report.table("CPU time of a contact in ns, median of nine, by the vectors that the kernel may use.",
               {"vectors", "limit [ns]", "law [ns]", "all [ns]", "law over limit", "all over limit"}, rows);
  report.claim("With the widest vectors the contact law takes no more than 2.5 times the machine's limit.",
               over <= 2.5);
}

// Only where scripts/track has left lines.
void add_tracking(Report& report) {
  std::ifstream file(results / "track.jsonl");
  std::vector<Json> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(Json::parse(line));
  if (lines.empty()) return;
  std::vector<std::string> head{"kernel"};
  for (const Json& line : lines) head.push_back(line.at("commit"));
  const Json& last = lines.back();
  head.insert(head.end(), {"CPU time, last over its base", "noise [%]", "verdict"});
  std::vector<std::vector<Json>> rows;
  for (const auto& [name, kernel] : last.at("kernels").items()) {
    std::vector<Json> row{name};
    for (const Json& line : lines)
      row.push_back(line.at("kernels").contains(name) ? Json(line["kernels"][name]["instructions"].get<double>() / 1e6)
                                                      : Json());
    const bool compared = kernel.contains("ratio");
    row.push_back(compared ? Json(interval(kernel["ratio"])) : Json());
    row.push_back(compared ? Json(100 * kernel["noise"].get<double>()) : Json());
    row.push_back(kernel.at("verdict"));
    rows.push_back(row);
  }
  report.heading("From commit to commit");
  report.table(
      "Millions of instructions of each fixed kernel, commit by commit (x86-64-v3, counted by callgrind), and CPU time "
      "of "
      "the last one over its base",
      head, rows);
}

}  // namespace

Json speed(const Settings& /*settings*/) {
  Report report("Speed", "How fast is furrow beside other programs on the same scene, and from commit to commit?");
  std::ifstream file = opened("rivals.json", "scripts/rivals");
  const Json rivals = Json::parse(file);
  add_rivals(report, rivals);
  add_limit(report);
  add_tracking(report);
  return report.data({{"rivals", rivals}}).json();
}

}  // namespace furrow::studies
