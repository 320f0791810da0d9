// The order certificate: for each method and each kind of force the observed order against the predicted one; beside it
// evaluations a step, the way back, and the energy of an undamped oscillator.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "studies/catalogue.h"
#include "studies/order_figures.h"
#include "studies/order_observed.h"
#include "studies/order_predicted.h"
#include "studies/order_trends.h"

namespace furrow::studies {
namespace {

std::string fixed(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string with_error(const Slope& s) { return s.points < 4 ? "-" : fixed(s.value, 2) + " ± " + fixed(s.error, 2); }

std::string shown(double order) { return order == std::round(order) ? fixed(order, 0) : fixed(order, 2); }

// ---- runs ----

Json to_json(const std::vector<Point>& points) {
  Json rows = Json::array();
  for (const Point& p : points)
    rows.push_back({p.step, p.tolerance, p.evaluations, p.per_step, p.position, p.velocity, p.failures});
  return rows;
}

double number(const Json& value) { return value.is_number() ? value.get<double>() : NAN; }

std::vector<Point> to_points(const Json& rows) {
  std::vector<Point> points;
  for (const Json& r : rows)
    points.push_back({number(r[0]), number(r[1]), number(r[2]), number(r[3]), number(r[4]), number(r[5]), r[6]});
  return points;
}

constexpr std::array<double, 5> angles{0.3, 0.2, 0.1, 0.05, 0.025};

Json trends(const MethodInfo& method, const Series& series) {
  const Count count = evaluations(method.name);
  Json json{{"per_step", count.per_step}, {"at_start", count.at_start}};
  if (method.controlled) return json;
  json["drift"] = Json::array();
  for (const double angle : angles) json["drift"].push_back(energy_drift(method.name, angle));
  for (const char* name : {"spring", "hertz"}) json[name] = to_json(observe_return(method.name, problem(name), series));
  return json;
}

Observations observe_all(const Settings& settings) {
  const Series series = settings.quick ? quick : full;
  const std::string form = settings.quick ? "/quick" : "/full";
  std::vector<Task> tasks;
  std::vector<std::pair<std::string, std::string>> cells;
  for (const MethodInfo& method : method_catalogue()) {
    for (const Problem& p : problems()) {
      if (!applies(method, p)) continue;
      cells.emplace_back(method.name, p.name);
      tasks.push_back({"observed/" + method.name + "/" + p.name + form,
                       [&method, &p, series] { return to_json(observe(method.name, p, series)); }});
    }
    cells.emplace_back(method.name, "");
    tasks.push_back({"trends/" + method.name + form, [&method, series] { return trends(method, series); }});
  }
  const std::vector<Json> results = run_tasks("order", settings, tasks);
  Observations all;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto& [method, p] = cells[k];
    if (p.empty()) {
      all.trends[method] = results[k];
    } else if (results[k].is_array()) {
      all.points[{method, p}] = to_points(results[k]);
    } else {
      all.failed[{method, p}] = results[k].value("failed", "");
    }
  }
  for (const MethodInfo& method : method_catalogue()) {
    for (const Problem& p : problems()) {
      const auto found = all.points.find({method.name, p.name});
      if (found != all.points.end()) all.verdicts[{method.name, p.name}] = verdict(method, p, found->second);
    }
  }
  return all;
}

// ---- tables ----

void kinds_table(Report& report) {
  std::vector<std::vector<Json>> rows;
  for (const Problem& p : problems())
    rows.push_back({p.title, p.event, p.limit == no_limit ? "p" : "min(p, " + shown(p.limit) + ")",
                    p.limit == no_limit    ? "-"
                    : p.controller_sees_it ? "yes"
                                           : "no"});
  report.table(
      "The kinds of force, what happens within a step, the order that it leaves to a method of order p, and "
      "whether an error estimate can see it.",
      {"motion", "event", "predicted order", "seen by error control"}, rows);
}

void velocity_table(Report& report, const Observations& all) {
  std::vector<std::string> head{"velocity"};
  for (const Problem& p : problems()) head.push_back(p.title);
  std::vector<std::vector<Json>> rows;
  for (const MethodInfo& method : method_catalogue()) {
    if (method.controlled) continue;
    std::vector<Json> row{method.name};
    for (const Problem& p : problems()) {
      const auto found = all.verdicts.find({method.name, p.name});
      if (found == all.verdicts.end()) {
        row.emplace_back("-");
        continue;
      }
      const Verdict& v = found->second;
      row.emplace_back(
          with_error(v.velocity) +
          (v.predicted ? (v.predicted->at_least ? " (≥ " : " (") + shown(v.predicted->velocity) + ")" : "") +
          (v.velocity_holds ? "" : " !"));
    }
    rows.push_back(std::move(row));
  }
  report.table(
      "Observed order of the velocity, in brackets the predicted one. After an elastic rebound it is at least "
      "the position's: a test of the exit speed alone would report an order that the motion does not have.",
      head, rows);
}

Slope exponent(const Observations& all, const std::string& method, const std::string& p) {
  const auto found = all.points.find({method, p});
  return found == all.points.end() ? Slope{} : fitted(found->second, &Point::position, 99, &Point::tolerance);
}

void controlled_table(Report& report, const Observations& all) {
  std::vector<std::string> head{"method"};
  for (const Problem& p : problems()) head.push_back(p.title);
  std::vector<std::vector<Json>> rows;
  for (const MethodInfo& method : method_catalogue()) {
    if (!method.controlled) continue;
    std::vector<Json> row{method.name};
    for (const Problem& p : problems()) row.emplace_back(with_error(exponent(all, method.name, p.name)));
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return;
  report.table(
      "Methods with error control: exponent s of error = C tolerance^s, tolerances from 1e-5 to 1e-10. 1 is what "
      "a tolerance promises; near 0 the tolerance has no say.",
      head, rows);
}

std::string drift_text(const Json& drift, std::size_t k) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2e", number(drift[k]));
  return text;
}

void trends_table(Report& report, const Observations& all) {
  std::vector<std::vector<Json>> rows;
  for (const MethodInfo& method : method_catalogue()) {
    const auto found = all.trends.find(method.name);
    if (found == all.trends.end() || !found->second.contains("per_step")) continue;
    const Json& t = found->second;
    std::vector<Json> row{method.name, fixed(number(t["per_step"]), 2), fixed(number(t["at_start"]), 0)};
    if (method.controlled) {
      row.insert(row.end(), {"-", "-", "-", "-", "-"});
    } else {
      const auto back = [&](const char* p) -> std::string {
        const std::vector<Point> points = to_points(t[p]);
        const Slope slope = fitted(points, &Point::position);
        return returns_exactly(points) ? "exact" : with_error(slope);
      };
      const auto want = predicted_return(method);
      const auto drift = predicted_drift(method.name);
      row.insert(row.end(),
                 {back("spring"), back("hertz"), want ? std::isinf(*want) ? "exact" : shown(*want) : "-",
                  drift_text(t["drift"], 2),
                  drift ? drift_text(Json::array({drift->factor * std::pow(true_angle(0.1), drift->power)}), 0) : "-"});
    }
    rows.push_back(std::move(row));
  }
  report.table(
      "Evaluations a step and extra ones at the start, counted; order of the distance from the start after a run "
      "that is reversed and run back, on a spring (where multistep methods pay for their start twice) and through "
      "a Hertz impact, against the prediction; relative change of the energy of an undamped oscillator in one "
      "period at h omega = 0.1, against the leading term of the amplification.",
      {"method", "evaluations a step", "at start", "way back: spring", "way back: Hertz", "predicted",
       "energy a period", "predicted"},
      rows);
}

// ---- claims ----

void order_claims(Report& report, const Observations& all) {
  int cells = 0, velocities = 0;
  double furthest = 0;
  std::string misses;
  for (const auto& [cell, v] : all.verdicts) {
    if (!v.predicted) continue;
    ++cells;
    velocities += v.velocity_holds ? 1 : 0;
    if (v.position_holds) furthest = std::max(furthest, std::fabs(v.position.value - v.predicted->position));
    if (!v.position_holds) misses += (misses.empty() ? "" : ", ") + cell.first + " on " + cell.second;
  }
  report.claim("In all " + std::to_string(cells) +
                   " pairs of a fixed-step method and a kind of force the observed order of "
                   "the position is the predicted one within three standard errors and " +
                   fixed(preasymptotic, 2) + "; the furthest is " + fixed(furthest, 2) + " off" +
                   (misses.empty() ? "." : "; except " + misses + "."),
               misses.empty());
  report.claim("So is the order of the velocity, in " + std::to_string(velocities) + " of " + std::to_string(cells) +
                   " pairs; after an elastic rebound it is at least the predicted one.",
               velocities == cells);
}

void rebound_claim(Report& report, const Observations& all) {
  const auto pece = all.verdicts.find({"pece", "hertz"});
  if (pece == all.verdicts.end()) return;
  const Verdict& v = pece->second;
  report.claim("The speed after an elastic rebound converges faster than the motion: with pece at order " +
                   with_error(v.velocity) + " where the position has " + with_error(v.position) +
                   ". A check of the restitution alone would certify an order that the method does not have.",
               v.velocity.value - v.position.value > 0.3);
}

void order_four_claim(Report& report, const Observations& all) {
  const auto at = [&](const char* method, const char* p) { return all.verdicts.at({method, p}).position; };
  const Slope two = at("pece", "damped_hertz"), four = at("rk4", "damped_hertz");
  report.claim("Through the touch of a damped Hertz contact rk4 has order " + with_error(four) + " and pece " +
                   with_error(two) + ": twice the evaluations buy no order.",
               std::fabs(two.value - four.value) < tolerance_of(two) + 3 * four.error);
}

void blind_claim(Report& report, const Observations& all) {
  std::string list;
  bool blind = true;
  for (const MethodInfo& method : method_catalogue()) {
    if (!method.controlled) continue;
    for (const char* p : {"tear", "stick_slip"}) {
      const auto found = all.points.find({method.name, p});
      if (found == all.points.end()) continue;
      const double gain = found->second.front().position / found->second.back().position;
      list += (list.empty() ? "" : ", ") + method.name + " on " + p + " " + fixed(gain, 1);
      blind = blind && gain < 300;
    }
  }
  report.claim(
      "Error control does not see what happens between steps: with the tolerance 100000 times smaller the error "
      "falls only by a factor of (" +
          list +
          "). A scene with friction or tears needs a largest step, or events "
          "that are located.",
      blind);
}

Json numbers(const Observations& all) {
  Json data = Json::object();
  const auto short_of = [](double v) { return std::isfinite(v) ? Json(std::round(v * 1e4) / 1e4) : Json(nullptr); };
  for (const auto& [cell, v] : all.verdicts) {
    data[cell.first][cell.second] = {
        {"position", {short_of(v.position.value), short_of(v.position.error)}},
        {"velocity", {short_of(v.velocity.value), short_of(v.velocity.error)}},
        {"predicted", v.predicted ? Json{v.predicted->position, v.predicted->velocity} : Json(nullptr)}};
  }
  return data;
}

}  // namespace

Json order(const Settings& settings) {
  const Observations all = observe_all(settings);
  const Series series = settings.quick ? quick : full;
  Report report(
      "Order certificate",
      "Does each method have the order that it claims, on each kind of force that a scene contains, and where "
      "not, why?");
  order_claims(report, all);
  order_four_claim(report, all);
  rebound_claim(report, all);
  blind_claim(report, all);
  report.text("Errors against exact solutions, root of the mean square over " + std::to_string(series.phases) +
              " runs that begin at different places within a step, with steps and ends of their own; " +
              std::to_string(series.sizes) + " step sizes, each " + fixed(series.ratio, 2) +
              " times smaller than the one before; the order is the slope of log error over log step, its error the "
              "standard error of that fit.");
  kinds_table(report);
  report.figure(matrix_figure(all));
  report.figure(slopes_figure(all));
  velocity_table(report, all);
  report.heading("Error control");
  controlled_table(report, all);
  report.heading("Evaluations, the way back, energy");
  trends_table(report, all);
  report.figure(energy_figure(all, {angles.begin(), angles.end()}));
  report.data(numbers(all));
  return report.json();
}

}  // namespace furrow::studies
