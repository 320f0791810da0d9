#include "verification/engines/judge.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/interrupt.h"
#include "verification/engines/asked.h"
#include "verification/engines/convergence.h"

namespace furrow::verification {
namespace {

Finding said(Finding f, CaseVerdict verdict, const std::string& words) {
  f.verdict = verdict;
  f.words = words;
  return f;
}

// The time of an event that is seen at the end of a step may be late by one step.
Finding judge_time(Finding f, const Json& seen, const std::vector<double>& h) {
  double worst = 0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    const double late = f.values[k] - f.expected;
    worst = std::max(worst, (std::fabs(late) - seen.value("slack", 0.0)) / h[k]);
  }
  f.error = worst;
  if (worst <= 1 + 1e-6) return said(f, CaseVerdict::right, "within the step");
  if (worst <= 3) return said(f, CaseVerdict::lower_order, "off by " + few(worst) + " steps");
  return said(f, CaseVerdict::another_law, "off by " + few(worst) + " steps");
}

Finding judge_interval(Finding f, const Json& seen) {
  const double low = seen["interval"][0], high = seen["interval"][1], got = f.values.back();
  f.expected = (low + high) / 2;
  f.error = std::fabs(got - f.expected) / ((high - low) / 2);
  if (got >= low && got <= high) return said(f, CaseVerdict::right, "inside [" + few(low) + ", " + few(high) + "]");
  f.limit = got;
  return said(f, CaseVerdict::another_law, few(got) + " is outside [" + few(low) + ", " + few(high) + "]");
}

Finding judge_exact(Finding f, const Json& seen) {
  const double scale = scale_of(seen, f.expected);
  for (const double value : f.values) f.error = std::max(f.error, std::fabs(value - f.expected) / scale);
  if (f.error <= seen["floor"].get<double>()) return said(f, CaseVerdict::right, "the same at every resolution");
  f.limit = f.values.back();
  return said(f, CaseVerdict::another_law, few(f.values.back()) + " in place of " + few(f.expected));
}

Json with_defaults(Json seen, const Json& whole) {
  for (const char* key : {"floor", "limit"}) {
    if (!seen.contains(key)) seen[key] = whole[key];
  }
  return seen;
}

void conclude(Judgement& j) {
  j.verdict = CaseVerdict::right;
  for (const Finding& f : j.findings) {
    if (f.verdict < j.verdict) continue;
    if (f.verdict == j.verdict && !j.words.empty() && j.verdict != CaseVerdict::right) continue;
    j.verdict = f.verdict;
    j.words = f.name + ": " + f.words;
  }
}

// An engine in which nothing moves would be the same in every view.
void refuse_nothing(const Json& of, const Json& seen, const std::vector<Json>& own) {
  for (const Json& original : of["observe"]) {
    if (original["name"] != seen["name"]) continue;
    const double expected = original.value("value", 0.0), got = value_of(own.back(), seen["name"]);
    if (std::fabs(got) < 1e-3 * std::fabs(expected))
      throw std::runtime_error("nothing to compare: in " + of["name"].get<std::string>() + " its " +
                               seen["name"].get<std::string>() + " is " + few(got) + " in place of " + few(expected));
  }
}

// Where a case is compared with another one, the other one's value takes the place of the expected one.
void subtract_own(const Json& seen, const std::vector<Json>& own, std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double other = seen["factor"].get<double>() * value_of(own[k], seen["name"]);
    values[k] -= seen["offset"].get<double>() + other;
  }
}

double scale_of_own(const Json& seen, const std::vector<Json>& own) {
  const double scale = std::fabs(value_of(own.back(), seen["name"])) + std::fabs(seen["offset"].get<double>());
  return scale > 0 ? scale : 1;
}

void judge_answers(Judgement& j, const Json& whole, const Asked& asked, const std::vector<Json>& own) {
  j.findings.clear();
  if (!whole.contains("observe") || whole["observe"].empty()) throw std::runtime_error("the case observes nothing");
  std::vector<double> h;
  for (const int steps : j.steps) h.push_back(whole["unit"].get<double>() / steps);
  for (const Json& plain : whole["observe"]) {
    Json seen = with_defaults(plain, whole);
    std::vector<double> values;
    for (const Json& answer : asked.answers) values.push_back(value_of(answer, seen["name"]));
    if (seen.value("kind", "") == "same") {
      refuse_nothing(case_named(whole["view"]["of"]), seen, own);
      subtract_own(seen, own, values);
      seen["scale"] = scale_of_own(seen, own);
      seen["value"] = 0.0;
    }
    j.findings.push_back(judge_observable(seen, j.steps, h, values, j.claimed));
  }
}

// Values that neither arrive nor settle at the resolutions of a case may do so at so many finer ones.
constexpr int most_refinements = 2;

bool undecided(const Judgement& j) {
  const auto open = [](const Finding& f) { return f.undecided; };
  return std::any_of(j.findings.begin(), j.findings.end(), open);
}

// Asks with twice as many steps as the finest resolutions that are close to each other; false if the engine does not
// answer there: then what it said before stands.
bool refine(Judgement& j, const Json& whole, const Engine& engine, Asked& asked) {
  if (whole.contains("view")) return false;  // its other case would have to follow
  const std::size_t known = j.steps.size();
  std::size_t begin = known - 1;
  while (begin > 0 && j.steps[known - 1] < close_resolutions * j.steps[begin - 1]) --begin;
  Judgement finer = j;
  finer.steps.clear();
  for (std::size_t k = begin; k < known; ++k) finer.steps.push_back(2 * j.steps[k]);
  try {
    const Asked more = ask(whole, engine, finer);
    if (more.cannot || finer.claimed != j.claimed) return false;
    for (const Json& answer : more.answers) {
      for (const Json& seen : whole["observe"]) value_of(answer, seen["name"]);
    }
    asked.answers.insert(asked.answers.end(), more.answers.begin(), more.answers.end());
  } catch (const Interrupted&) {  // no word of the engine
    throw;
  } catch (const std::runtime_error&) {
    return false;
  }
  j.steps.insert(j.steps.end(), finer.steps.begin(), finer.steps.end());
  return true;
}

}  // namespace

std::string to_string(CaseVerdict verdict) {
  constexpr const char* words[] = {"right", "cannot", "lower order", "another law", "failed"};
  return words[static_cast<int>(verdict)];
}

Finding judge_observable(const Json& seen, const std::vector<int>& steps, const std::vector<double>& h,
                         const std::vector<double>& values, double claimed) {
  if (values.size() != steps.size() || h.size() != steps.size())
    throw std::logic_error("an observable of another number of resolutions");
  Finding f{.name = seen["name"], .unit = seen["unit"], .values = values, .expected = seen.value("value", 0.0)};
  const std::string kind = seen.value("kind", "converging");
  if (kind == "step") return judge_time(f, seen, h);
  if (kind == "interval") return judge_interval(f, seen);
  if (kind == "exact" || kind == "same") return judge_exact(f, seen);
  return judge_converging(f, seen, steps, claimed);
}

Judgement judge_case(const Json& whole, const Engine& engine) {
  Judgement j{.name = whole["name"], .title = whole["title"], .steps = whole["steps"].get<std::vector<int>>()};
  try {
    Asked asked = ask(whole, engine, j);
    Asked other;
    if (asked.cannot) {
      j.verdict = CaseVerdict::cannot, j.words = *asked.cannot;
      return j;
    }
    if (whole.contains("view")) {
      other = ask(case_named(whole["view"]["of"]), engine, j);
      if (other.cannot) throw std::runtime_error("it can do this view alone: " + *other.cannot);
    }
    judge_answers(j, whole, asked, other.answers);
    for (int finer = 0; finer < most_refinements && undecided(j) && refine(j, whole, engine, asked); ++finer)
      judge_answers(j, whole, asked, other.answers);
    conclude(j);
  } catch (const Interrupted&) {  // no word of the engine
    throw;
  } catch (const Json::exception& fault) {
    j.words = std::string("the answer does not follow the protocol: ") + fault.what();
  } catch (const std::runtime_error& fault) {
    j.words = fault.what();
  }
  return j;
}

}  // namespace furrow::verification
