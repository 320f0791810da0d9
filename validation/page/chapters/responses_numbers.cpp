// What others have printed beside furrow's numbers: the files of verification/published, suite by suite.
#include <algorithm>
#include <cmath>
#include <set>

#include "scene/wording.h"
#include "validation/page/chapters/responses_parts.h"
#include "verification/studies/numbers_of_others.h"

namespace furrow::validation {
namespace {

using namespace verification;

struct Count {
  std::string suite;
  std::set<std::string> said{}, not_said{};  // models, tests or cases of the suite
  int problems = 0, numbers = 0, within = 0, known_off = 0;
};

std::vector<Count> counts() {
  std::vector<Count> all;
  for (const ProblemOfOthers& p : problems_of_others()) {
    auto c = std::find_if(all.begin(), all.end(), [&](const Count& one) { return one.suite == p.suite; });
    if (c == all.end()) c = all.insert(all.end(), Count{.suite = p.suite});
    (p.cannot.empty() ? c->said : c->not_said).insert(p.of);
    c->problems += p.cannot.empty() ? 1 : 0;
    for (const NumberOfOthers& n : p.numbers) {
      ++c->numbers;
      c->within += n.off() <= n.tolerance ? 1 : 0;
      c->known_off += n.known_off.empty() ? 0 : 1;
    }
  }
  return all;
}

std::string why(const NumberOfOthers& n) {
  if (n.known_off.empty()) return n.reason;
  return n.reason == "as known" ? n.known_off : n.reason + "; " + n.known_off;
}

void add_suite(Report& report, const std::string& suite) {
  std::vector<std::vector<Json>> rows;
  std::string source;
  for (const ProblemOfOthers& p : problems_of_others()) {
    if (p.suite != suite) continue;
    if (source.empty()) source = p.source;
    for (const NumberOfOthers& n : p.numbers) {
      rows.push_back({p.name, p.title + ": " + n.name + " [" + n.unit + "]", rounded(n.got, 6), rounded(n.number, 6),
                      n.printed + (n.said.empty() ? "" : " (" + n.said + ")"), percent(n.off()), percent(n.tolerance),
                      why(n), p.source});
    }
  }
  report.table(suite +
                   ": furrow's number beside the published one. Off and tolerance are shares of the number, or of the "
                   "greatest of its kind where it is near nothing.",
               {"case", "what", "furrow", "published", "as printed", "off", "tolerance", "why so far", "source"}, rows);
}

}  // namespace

void add_published_numbers(Report& report) {
  report.heading("Published cases, number by number");
  std::vector<std::vector<Json>> rows, cannot;
  int numbers = 0, within = 0, known_off = 0;
  for (const Count& c : counts()) {
    rows.push_back({c.suite, c.said.size(), c.not_said.size(), c.problems, c.numbers, c.within, c.known_off});
    numbers += c.numbers, within += c.within, known_off += c.known_off;
  }
  report.table(
      "Published cases by suite: of its models or tests furrow can say so many and cannot say so many; problems that "
      "are run, numbers compared, of these within their tolerance, and known to be off.",
      {"suite", "said", "not said", "problems", "numbers", "within", "known off"}, rows);
  report.claim({.text = "Published numbers of other codes, papers and measurements that furrow comes within the stated "
                        "tolerance of, each with its reason; " +
                        std::to_string(known_off) + " of them are known to be off, by what the tolerance says.",
                .value = std::to_string(within) + " of " + std::to_string(numbers),
                .aim = "all",
                .holds = within == numbers});
  for (const Count& c : counts()) add_suite(report, c.suite);
  for (const ProblemOfOthers& p : problems_of_others()) {
    if (!p.cannot.empty()) cannot.push_back({p.suite, p.of, p.title, p.cannot});
  }
  report.table("What cannot be said in furrow.", {"suite", "model", "case", "why"}, cannot);
}

}  // namespace furrow::validation
