#include "validation/page/chapters/statements_why.h"

#include <algorithm>
#include <cmath>

#include "output/files.h"
#include "validation/page/chapters/convergence_settled.h"
#include "validation/page/chapters/in_words.h"
#include "validation/page/chapters/readings_parts.h"

namespace furrow::validation {
namespace {

// Null if the study is not there, or in its quick form.
const Numbers* whole(const Shelf& shelf, const std::string& study) {
  try {
    const Numbers& numbers = shelf.of(study);
    return numbers.quick() ? nullptr : &numbers;
  } catch (const FileError&) {
    return nullptr;
  }
}

std::string percent(double share) { return three_digits(100 * share) + " %"; }

// The part of verdict_of that decided, in words.
std::string decided(const Statement& s, const Sample& sample) {
  const std::size_t members = sample.members();
  if (members == 0) return "no run says it";
  if (is_yes_or_no(s)) return count_of_yes(sample) + " come to their end, half must";
  if (s.holds || s.relation == "below" || s.relation == "by" || s.relation == "above") {
    const std::array<double, 2> range = s.holds                 ? *s.holds
                                        : s.relation == "above" ? std::array{s.value, infinity}
                                                                : std::array{-infinity, s.value};
    std::string asked = std::isfinite(range[0]) ? "at least " + three_digits(range[0]) : "";
    if (std::isfinite(range[1])) asked += (asked.empty() ? "" : " and ") + ("at most " + three_digits(range[1]));
    return percent(sample.share(range)) + " of the runs keep " + asked + ", half must";
  }
  if (!s.expect.empty()) {
    const auto same = std::count(sample.words.begin(), sample.words.end(), s.expect);
    return std::to_string(same) + " of " + std::to_string(members) + " runs say " + s.expect + ", half must";
  }
  if (2 * sample.numbers.size() < members) return "it does not happen in most runs";
  const double off = sample.quantile(0.5) - s.value;
  return "the median is " + percent(std::fabs(off / s.value)) + (off > 0 ? " above" : " below") + ", a tenth would do" +
         (sample.numbers.size() >= 20 ? ", or to lie among the packings" : "");
}

// Figures of the scene that show it, the likeliest first, or the scene as a whole.
Json shown_in_figures(const Statement& s) {
  Json links = Json::array();
  if (s.observable.find("tear") != std::string::npos || s.observable.find("torn") != std::string::npos)
    links.push_back("figure_" + s.scene + "_tears");
  if (s.observable.find("stress") != std::string::npos || s.observable.find("moved") != std::string::npos)
    links.push_back("figure_" + s.scene + "_snapshots");
  if (s.unit == "N" || s.observable.find("force") != std::string::npos) links.push_back("figure_" + s.scene + "_force");
  links.push_back(s.scene);
  return links;
}

void join(std::string& list, const std::string& words) {
  if (!words.empty()) list += (list.empty() ? "" : "; ") + words;
}

}  // namespace

Reasons::Reasons(const Shelf& shelf) : convergence_(whole(shelf, "convergence")) {
  const Numbers* readings = whole(shelf, "readings");
  if (readings == nullptr) return;
  try {
    found_ = kept_search(*readings);
  } catch (const std::out_of_range&) {  // of another search
  }
}

std::string Reasons::step(const Statement& statement, const std::string& group) const {
  if (convergence_ == nullptr) return {};
  const ConvergencePlan plan = convergence_plan(false);
  for (const ConvergenceCase& c : plan.cases) {
    if (c.scene + " " + to_string(c.reading) != group) continue;
    try {
      return step_words(*convergence_, plan, c, statement.id);
    } catch (const std::out_of_range&) {
      return {};  // the study is of an earlier form
    }
  }
  return {};
}

std::string Reasons::spheres_at_the_papers_step() const {
  if (convergence_ == nullptr) return {};
  std::string words;
  for (const char* scene : {"scenario_2", "scenario_3"}) {
    const std::string unstable = instability_words(*convergence_, {{scene, Reading::sphere}, "pece", papers_step});
    if (!unstable.empty()) join(words, "in scene " + std::string(scene).substr(9) + " " + unstable);
  }
  return words.empty() ? "" : ": " + words;
}

// The closest that any reading tried comes to the statement, if one comes nearer than the literal one.
std::string Reasons::other_reading(const Statement& statement) const {
  if (!found_ || found_->points.empty()) return {};
  const auto misfit = [&](const ReadPoint& p) { return row_misfit(statement, p.said.at(statement.scene)); };
  const auto best = std::min_element(found_->points.begin(), found_->points.end(),
                                     [&](const ReadPoint& a, const ReadPoint& b) { return misfit(a) < misfit(b); });
  if (!(misfit(*best) < misfit(found_->points.front()))) return "no reading tried comes nearer";
  return "nearest of all readings tried: " + said_in(best->said.at(statement.scene), statement.id) + " with " +
         words_of(best->reading);
}

std::string Reasons::why(const Statement& statement, const Sample& sample, const std::string& group,
                         const std::string& verdict) const {
  if (verdict == "reproduced" || verdict == "not testable") return {};
  std::string words = decided(statement, sample);
  join(words, step(statement, group));
  if (group.ends_with("disc")) join(words, other_reading(statement));
  return words;
}

Json statement_cell(const Statement& statement, const std::string& group) {
  return {{"text", statement.quantity},
          {"id", "statement " + statement.id + (group.ends_with("sphere") ? " spheres" : "")},
          {"links", shown_in_figures(statement)}};
}

Json paper_cell(const Statement& statement, const std::string& said) {
  return {{"text", said}, {"below", statement.where}, {"file", "statements.toml"}};
}

}  // namespace furrow::validation
