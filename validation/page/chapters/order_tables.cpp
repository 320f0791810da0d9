// What each kind of force leaves of an order, what restores it, and how else methods differ.
#include <cmath>

#include "validation/page/chapters/order_parts.h"
#include "verification/studies/order_cure.h"

namespace furrow::validation {

using namespace verification;

std::string with_error(const Slope& s) { return s.points < 4 ? "-" : fixed(s.value, 2) + " ± " + fixed(s.error, 2); }

std::string in_short(const Slope& s) {
  return s.points < 4 ? "–" : fixed(s.value, 2) + "(" + fixed(100 * s.error, 0) + ")";
}

void kinds_table(Report& report) {
  std::vector<std::vector<Json>> rows;
  for (const Problem& p : problems())
    rows.push_back({p.title, p.event, p.limit == no_limit ? "p" : "min(p, " + shown_order(p.limit) + ")",
                    p.limit == no_limit    ? "-"
                    : p.controller_sees_it ? "yes"
                                           : "no"});
  report.table(
      "The kinds of force, what happens within a step, the order that it leaves to a method of order p, and "
      "whether an error estimate can see it.",
      {"motion", "event", "predicted order", "seen by error control"}, rows);
}

namespace {

// s of error = C tolerance^s.
Slope exponent_of(const Observations& all, const std::string& method, const std::string& p) {
  const auto found = all.points.find({method, p});
  return found == all.points.end() ? Slope{} : fitted_exponent(found->second);
}

}  // namespace

void controlled_table(Report& report, const Observations& all) {
  std::vector<std::string> head{"method"};
  for (const Problem& p : problems()) head.push_back(p.title);
  std::vector<std::vector<Json>> rows;
  for (const MethodInfo& method : method_catalogue()) {
    if (!method.controlled) continue;
    std::vector<Json> row{method.name};
    for (const Problem& p : problems()) row.emplace_back(in_short(exponent_of(all, method.name, p.name)));
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return;
  report.table(
      "Methods with error control: exponent s of error = C tolerance^s, tolerances from 1e-5 to 1e-10. 1 is what "
      "a tolerance promises; near 0 the tolerance has no say. In brackets the standard error in units of the last "
      "digit.",
      head, rows);
}

void cure_table(Report& report, const Observations& all) {
  std::vector<std::string> head{"method"};
  for (const char* p : graded_problems) {
    for (const int grading : gradings) head.push_back(problem(p).title + ", g = " + std::to_string(grading));
  }
  std::vector<std::vector<Json>> rows;
  for (const char* method : graded_methods) {
    std::vector<Json> row{method};
    for (const char* p : graded_problems) {
      for (const int grading : gradings) {
        const Slope slope = fitted(all.cured.at({method, p, grading}), &Point::position);
        row.emplace_back(in_short(slope) + " of\u00a0" +
                         shown_order(predicted_graded(make_method(method)->info(), problem(p), grading)));
      }
    }
    rows.push_back(std::move(row));
  }
  report.table(
      "The cure: a step ends at the touch (just inside: at the touch itself the force is still that of free "
      "flight), the next ones grow as t - t0 = T (n/N)^g; observed order of the position in the contact, "
      "its standard error in units of the last digit, and of what is predicted, min(p, g (a + 1)).",
      head, rows);
}

namespace {

std::string back_text(const std::vector<Point>& points) {
  return returns_exactly(points) ? "exact" : in_short(fitted_return(points));
}

}  // namespace

void trends_table(Report& report, const Observations& all) {
  constexpr int shown_angle = 2;
  static_assert(drift_angles[shown_angle] == 0.1);
  std::vector<std::vector<Json>> rows;
  for (const MethodInfo& method : method_catalogue()) {
    const auto found = all.trends.find(method.name);
    if (found == all.trends.end()) continue;
    const Trends& t = found->second;
    std::vector<Json> row{method.name, fixed(t.count.per_step, 2), fixed(t.count.at_start, 0)};
    if (method.controlled) {
      row.insert(row.end(), {"-", "-", "-", "-", "-"});
    } else {
      const auto want = predicted_return(method);
      const auto drift = amplified_drift(method.name, drift_angles[shown_angle]);
      row.insert(row.end(), {back_text(t.spring), back_text(t.hertz),
                             want ? std::isinf(*want) ? "exact" : shown_order(*want) : "-",
                             scientific(t.drift.at(shown_angle), 2), drift ? scientific(*drift, 2) : "-"});
    }
    rows.push_back(std::move(row));
  }
  report.table(
      "Evaluations a step and extra ones at the start, counted; order of the distance from the start after a run "
      "that is reversed and run back, on a spring (where multistep methods pay for their start twice) and through "
      "a Hertz impact, against the prediction; relative change of the energy of an undamped oscillator in one "
      "period at h omega = 0.1, against the amplification of the scheme. In brackets the standard error in units of "
      "the last digit.",
      {"method", "evaluations a step", "at start", "way back: spring", "way back: Hertz", "predicted",
       "energy a period", "predicted"},
      rows);
}

}  // namespace furrow::validation
