#include "verification/engines/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "scene/interrupt.h"
#include "scene/wording.h"
#include "verification/engines/asked.h"

namespace furrow::verification {
namespace {

// An observed order may be below the predicted one by so much: at three resolutions the next term of the error, and the
// phase in which events fall into steps, bend the slope by up to a third.
constexpr double slack = 0.35;
// Less is no order: nothing is arrived at.
constexpr double least_order = 0.4;
// Resolutions within this factor belong together.
constexpr double close = 1.2;

std::string few(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

// Errors by resolution; of resolutions that are close to each other the root of the mean square, so that the phase in
// which an event falls into a step makes less of a difference.
struct Errors {
  std::vector<double> steps, error;
};

Errors grouped(const std::vector<int>& steps, const std::vector<double>& errors) {
  Errors all;
  std::size_t begin = 0;
  while (begin < steps.size()) {
    double logs = 0, squares = 0, count = 0;
    std::size_t k = begin;
    for (; k < steps.size() && steps[k] < close * steps[begin]; ++k, ++count) {
      logs += std::log(steps[k]);
      squares += errors[k] * errors[k];
    }
    all.steps.push_back(std::exp(logs / count));
    all.error.push_back(std::sqrt(squares / count));
    begin = k;
  }
  return all;
}

double slope(const Errors& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0, n = 0;
  for (std::size_t k = 0; k < errors.steps.size(); ++k) {
    if (!(errors.error[k] > 0)) continue;
    const double x = -std::log(errors.steps[k]), y = std::log(errors.error[k]);
    sx += x, sy += y, sxx += x * x, sxy += x * y, ++n;
  }
  return n < 2 ? NAN : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

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

double scale_of(const Json& seen, double expected) {
  if (seen.contains("scale")) return seen["scale"];
  return std::fabs(expected) > 0 ? std::fabs(expected) : 1;
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

// How far the values may still be from where they go if the last change is one of this order: an error C h^p changes by
// C h^p (r^p - 1) from the resolution before, with steps r times as long, and by little more or less with the phase of
// events. Of resolutions that are close to each other the two that differ most count, since a change may be small by
// chance. Earlier changes say nothing: coarse values may be wild.
double left_to_go(const std::vector<int>& steps, const std::vector<double>& values, double order) {
  constexpr double phase = 1.8;
  const auto begin_of_group = [&](std::size_t end) {
    std::size_t begin = end - 1;
    while (begin > 0 && steps[end - 1] < close * steps[begin - 1]) --begin;
    return begin;
  };
  const std::size_t last = begin_of_group(values.size());
  double most = 0;
  for (std::size_t i = last > 0 ? begin_of_group(last) : 0; i < last; ++i) {
    for (std::size_t k = last; k < values.size(); ++k) {
      const double growth = std::pow(static_cast<double>(steps[k]) / steps[i], order) - 1;
      most = std::max(most, phase * std::fabs(values[k] - values[i]) / growth);
    }
  }
  return most;
}

Finding judge_converging(Finding f, const Json& seen, const std::vector<int>& steps, double claimed) {
  const double scale = scale_of(seen, f.expected), floor = seen["floor"];
  std::vector<double> errors;
  for (const double value : f.values) errors.push_back(std::fabs(value - f.expected) / scale);
  const Errors by_step = grouped(steps, errors);
  f.error = by_step.error.back();
  f.order = slope(by_step);
  f.limit = f.values.back();
  if (f.error <= floor) return said(f, CaseVerdict::right, "error " + few(f.error));
  const double predicted = std::min(claimed, seen["limit"].get<double>());
  const std::string orders =
      "error " + few(f.error) + ", order " + few(f.order) + " (" + few(predicted) + " predicted)";
  const auto arrives = [&](double order) {
    return f.order >= order && f.error * scale <= left_to_go(steps, f.values, std::min(order, 1.0)) + floor * scale;
  };
  if (arrives(predicted - slack)) return said(f, CaseVerdict::right, orders);
  if (arrives(least_order)) return said(f, CaseVerdict::lower_order, orders);
  const std::size_t n = f.values.size();
  const double last = std::fabs(f.values[n - 1] - f.values[n - 2]), first = std::fabs(f.values[1] - f.values[0]);
  const bool settles = last < 0.7 * first || last <= floor * scale || last < 0.1 * f.error * scale;
  constexpr int digits = 8;  // enough to tell two apart that are taken for different ones
  if (settles)
    return said(f, CaseVerdict::another_law,
                "goes to " + rounded(f.limit, digits) + " in place of " + rounded(f.expected, digits) + ", off by " +
                    few(f.error));
  return said(f, CaseVerdict::failed, "does not converge: " + orders);
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
    const Asked asked = ask(whole, engine, j);
    std::vector<Json> own;
    if (asked.cannot) {
      j.verdict = CaseVerdict::cannot, j.words = *asked.cannot;
      return j;
    }
    if (whole.contains("view")) {
      const Asked other = ask(case_named(whole["view"]["of"]), engine, j);
      if (other.cannot) throw std::runtime_error("it can do this view alone: " + *other.cannot);
      own = other.answers;
    }
    judge_answers(j, whole, asked, own);
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
