// Does each method carry what others have solved, and does its error fall as it says?
#include "verification/studies/published.h"

#include <map>

#include "scene/wording.h"
#include "validation/page/chapters/chapters.h"
#include "verification/studies/kept_numbers.h"
#include "verification/studies/order_predicted.h"

namespace furrow::validation {
namespace {

using namespace verification;

std::string stated(const MethodInfo& method) {
  Problem smooth;
  smooth.limit = no_limit;
  return method.controlled ? "tolerance^" + rounded(predicted_exponents(method, smooth).smooth, 2)
                           : "h^" + std::to_string(method.order);
}

std::string shown(const Json& cell) {
  if (cell.contains("cannot")) return "cannot";
  if (cell.contains("failed")) return "failed !";
  const std::string words =
      cell["slope"].is_null() ? "< " + scientific(number(cell["error"]), 0) : fixed(cell["slope"], 2);
  return words + (cell["holds"] ? "" : " !");
}

void append(std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; }

// What the cells say together.
struct Count {
  int holding = 0, carried = 0;
  std::string known, wrong;
  std::map<std::string, std::string> cannot;  // reason: methods

  void add(const Json& cell, const std::string& method, const std::string& problem) {
    if (cell.contains("cannot")) {
      std::string& list = cannot[cell["cannot"]];
      if (!list.ends_with(method)) append(list, method);
      return;
    }
    ++carried;
    if (cell.value("holds", false)) {
      ++holding;
    } else {
      append(cell.value("known", false) ? known : wrong, method + " on " + problem);
    }
  }
};

}  // namespace

Report published(const Shelf& shelf) {
  const furrow::Numbers& numbers = shelf.of("published");
  Report report("Published problems",
                "Does each method carry what others have solved, and does its error fall as it says?");
  std::vector<std::string> head{"method", "says"};
  std::vector<std::vector<Json>> rows, problems;
  for (const PublishedProblem& p : published_problems()) {
    head.push_back(p.name);
    problems.push_back({p.name, p.equation});
  }
  Count count;
  for (const MethodInfo& method : method_catalogue()) {
    std::vector<Json> row{method.name, stated(method)};
    for (const PublishedProblem& p : published_problems()) {
      const Json& cell = numbers.at(published_key(method, p));
      row.emplace_back(shown(cell));
      count.add(cell, method.name, p.name);
    }
    rows.push_back(row);
  }
  report.claim(
      {.text = "Pairs of a method and a problem that it can carry in which the error falls as the method says, "
               "down to where round-off begins" +
               (count.known.empty() ? "" : "; known to fail: " + count.known) +
               (count.wrong.empty() ? "." : "; wrong: " + count.wrong + "."),
       .value = std::to_string(count.holding) + " of " + std::to_string(count.carried),
       .aim = "all but those known to fail",
       .holds = count.wrong.empty() && count.holding > 0});
  report.table(
      "Slope of log error over log step, or over log tolerance, at the end of each problem. < 1e-13: the least "
      "error, where too few stand above round-off for a slope, or a controlled method needs few steps. An "
      "exclamation mark: not as it says. F2 is stepped over, which leaves first order; in F2, located, steps "
      "end at the jumps.",
      head, rows);
  report.table("The problems.", {"name", "equation"}, problems);
  for (const auto& [why, methods] : count.cannot) report.text("Cannot: " + methods + ": " + why + ".");
  return report;
}

}  // namespace furrow::validation
