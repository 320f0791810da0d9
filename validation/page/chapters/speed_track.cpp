// Of furrow alone: from commit to commit.
#include <map>
#include <set>

#include "validation/page/chapters/speed_parts.h"
#include "validation/page/names.h"

namespace furrow::validation {

// ---- from commit to commit: scripts/track ----

namespace {

const Json* kernel_of(const Json& line, const std::string& name) {
  for (const Json& kernel : line.at("benchmarks")) {
    if (kernel.at("run_name") == name) return &kernel;
  }
  return nullptr;
}

// "d1151cc, 2026-01-31"
std::string dated(const Json& line) {
  return line.at("commit").get<std::string>() + ", " + line.value("date", "").substr(0, 10);
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
    figure.variables["kernel_" + std::to_string(panel)] = scene_words(name);
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
  figure.variables["first_commit"] = dated(lines.front());
  figure.variables["last_commit"] = dated(lines.back());
  figure.blocks["points"] = points;
  return figure;
}

}  // namespace

void add_tracking(Report& report, const Numbers& numbers) {
  const Json track = measured(numbers, "track.jsonl");
  const std::vector<Json> lines(track.begin(), track.end());
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
    std::vector<Json> row{scene_words(name)};
    for (std::size_t k = lines.size() - std::min(shown, lines.size()); k < lines.size(); ++k) {
      const Json* entry = kernel_of(lines[k], name);
      row.push_back(entry ? Json(entry->at("instructions").get<double>() / 1e6) : Json());
    }
    const bool compared = kernel.contains("ratio");
    row.push_back(kernel.at("cpu_time"));
    row.push_back(compared ? Json(spread(kernel["ratio"])) : Json());
    row.push_back(compared ? Json(100 * kernel["noise"].get<double>()) : Json());
    row.emplace_back(kernel.at("error").is_null() ? "–" : rounded(kernel["error"], 2));
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

}  // namespace furrow::validation
