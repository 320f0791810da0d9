// Methods by published problems, as a table.
#include <algorithm>
#include <cstdio>
#include <map>

#include "verification/studies/order_predicted.h"
#include "verification/studies/published_table.h"
#include "verification/studies/studies.h"

namespace furrow::verification {
namespace {

std::string with_digits(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

Json to_json(const MethodInfo& method, const PublishedProblem& problem) {
  const PublishedCell cell = published_cell(method, problem);
  const auto finest = std::min_element(cell.points.begin(), cell.points.end(),
                                       [](const Point& a, const Point& b) { return a.position < b.position; });
  const bool by_slope = cell.cannot.empty() && !cell.at_floor && !cell.few_steps;
  const std::string shown = !cell.cannot.empty() ? "cannot"
                            : by_slope           ? with_digits(cell.slope.value, "%.2f")
                                                 : "< " + with_digits(finest->position, "%.0e");
  return {{"shown", shown + (cell.holds || !cell.cannot.empty() ? "" : " !")},
          {"cannot", cell.cannot},
          {"holds", cell.holds},
          {"known", known_to_fail(method, problem)}};
}

std::string stated(const MethodInfo& method) {
  Problem smooth;
  smooth.limit = no_limit;
  return method.controlled ? "tolerance^" + with_digits(predicted_exponents(method, smooth).smooth, "%.2g")
                           : "h^" + std::to_string(method.order);
}

}  // namespace

Json published(const Settings& settings) {
  std::vector<Task> tasks;
  for (const MethodInfo& method : method_catalogue()) {
    for (const PublishedProblem& problem : published_problems())
      tasks.push_back(
          {"published " + method.name + ", " + problem.name, [&method, &problem] { return to_json(method, problem); }});
  }
  const std::vector<Json> results = run_tasks("published", settings, tasks);

  Report report("Published problems",
                "Does each method carry what others have solved, and does its error fall as it says?");
  std::vector<std::string> head{"method", "says"};
  std::vector<std::vector<Json>> rows, problems;
  for (const PublishedProblem& p : published_problems()) {
    head.push_back(p.name);
    problems.push_back({p.name, p.equation});
  }
  std::size_t task = 0;
  int holding = 0, carried = 0;
  std::string known, wrong;
  std::map<std::string, std::string> cannot;  // reason: methods
  for (const MethodInfo& method : method_catalogue()) {
    std::vector<Json> row{method.name, stated(method)};
    for (const PublishedProblem& p : published_problems()) {
      const Json& cell = results[task++];
      if (cell.contains("failed")) throw std::runtime_error(tasks[task - 1].key + ": " + cell.dump());
      row.push_back(cell["shown"]);
      if (const std::string why = cell["cannot"]; !why.empty()) {
        std::string& list = cannot[why];
        if (!list.ends_with(method.name)) list += (list.empty() ? "" : ", ") + method.name;
        continue;
      }
      ++carried;
      holding += cell["holds"] ? 1 : 0;
      std::string& list = cell["known"] ? known : wrong;
      if (!cell["holds"]) list += (list.empty() ? "" : ", ") + method.name + " on " + p.name;
    }
    rows.push_back(row);
  }
  report.claim("In " + std::to_string(holding) + " of " + std::to_string(carried) +
                   " pairs of a method and a problem that it can carry the error falls as the method says, down to "
                   "where round-off begins" +
                   (known.empty() ? "" : "; known to fail: " + known) +
                   (wrong.empty() ? "." : "; wrong: " + wrong + "."),
               wrong.empty());
  report.table(
      "Slope of log error over log step, or over log tolerance, at the end of each problem. < 1e-13: the least "
      "error, where too few stand above round-off for a slope, or a controlled method needs few steps. An "
      "exclamation mark: not as it says. F2 is stepped over, which leaves first order; in F2, located, steps "
      "end at the jumps.",
      head, rows);
  report.table("The problems.", {"name", "equation"}, problems);
  for (const auto& [why, methods] : cannot) report.text("Cannot: " + methods + ": " + why + ".");
  return report.json();
}

}  // namespace furrow::verification
