// The order certificate: for each method and each kind of force the observed order against the predicted one; beside it
// evaluations a step, the way back, and the energy of an undamped oscillator.
#include <algorithm>
#include <array>
#include <cmath>

#include "verification/studies/order_cure.h"
#include "verification/studies/order_figures.h"
#include "verification/studies/order_observed.h"
#include "verification/studies/order_predicted.h"
#include "verification/studies/order_tables.h"
#include "verification/studies/order_trends.h"
#include "verification/studies/studies.h"

namespace furrow::verification {
namespace {

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
    } else {
      // A run that failed as a whole has no points, thus no order.
      all.points[{method, p}] = results[k].is_array() ? to_points(results[k]) : std::vector<Point>();
    }
  }
  for (const char* method : graded_methods) {
    for (const char* p : graded_problems) {
      for (const int grading : gradings)
        all.cured[{method, p, grading}] = observe_graded(method, problem(p), grading, quick);
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

void order_claims(Report& report, const Observations& all) {
  int cells = 0, velocities = 0;
  double furthest = 0;
  std::string misses;
  std::vector<double> tolerances;
  for (const auto& [cell, v] : all.verdicts) {
    if (!v.predicted) continue;
    ++cells;
    if (v.position.points >= 4) tolerances.push_back(v.position_gate);
    velocities += v.velocity_holds ? 1 : 0;
    if (v.position_holds)
      furthest = std::max({furthest, v.predicted->position - v.position.value, v.position.value - v.predicted->most});
    if (!v.position_holds) misses += (misses.empty() ? "" : ", ") + cell.first + " on " + cell.second;
  }
  std::sort(tolerances.begin(), tolerances.end());
  report.claim(
      "In all " + std::to_string(cells) +
          " pairs of a fixed-step method and a kind of force the observed order of the position is the "
          "predicted one within three standard errors (Student's t of the fit) and twice what the next power of the "
          "step does to the slope, or 0.05; but no more than half of what the order would fall by with a method of one "
          "order less, and its points stand on a line (correlation). That is " +
          fixed(tolerances.at(tolerances.size() / 2), 2) + " in the middle, " + fixed(tolerances.back(), 2) +
          " at most; the furthest is " + fixed(furthest, 2) + " off" +
          (misses.empty() ? "." : "; except " + misses + "."),
      misses.empty());
  report.claim("So is the order of the velocity, in " + std::to_string(velocities) + " of " + std::to_string(cells) +
                   " pairs; after an elastic rebound or a tear that is located it is at least the predicted one.",
               velocities == cells);
}

void cure_claim(Report& report, const Observations& all) {
  const auto cured = [&](const char* method, int grading) {
    return fitted(all.cured.at({method, "damped_hertz_inside", grading}), &Point::position);
  };
  const auto plain = [&](const char* method, const char* p) { return all.verdicts.at({method, p}).position; };
  const Slope two = cured("pece", 2), four = cured("rk4", 4);
  report.claim(
      "Steps that end at the touch and grow from there restore the order in a damped Hertz contact: pece from " +
          with_error(plain("pece", "damped_hertz_inside")) + " to " + with_error(two) + " (g = 2), rk4 from " +
          with_error(plain("rk4", "damped_hertz_inside")) + " to " + with_error(four) +
          " (g = 4). To locate the touch alone leaves " + with_error(cured("rk4", 1)) + ".",
      std::fabs(two.value - 2) <= tolerance_of(two) && std::fabs(four.value - 4) <= tolerance_of(four));
  report.claim("To locate the tear within its step takes rk4 from order " + with_error(plain("rk4", "tear")) + " to " +
                   with_error(plain("rk4", "located_tear")) + ", pece from " + with_error(plain("pece", "tear")) +
                   " to " + with_error(plain("pece", "located_tear")) + ".",
               all.verdicts.at({"rk4", "located_tear"}).position_holds &&
                   all.verdicts.at({"pece", "located_tear"}).position_holds);
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
               std::fabs(two.value - four.value) < tolerance_of(two) + tolerance_of(four));
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
      blind && !list.empty());
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
  cure_claim(report, all);
  rebound_claim(report, all);
  blind_claim(report, all);
  report.text("Errors against exact solutions, root of the mean square over " + std::to_string(series.phases) +
              " runs that begin at different places within a step, with steps and ends of their own; " +
              std::to_string(series.sizes) + " step sizes, each " + fixed(series.ratio, 2) +
              " times smaller than the one before (closer where a high order soon reaches round-off); the order is the "
              "slope of log error over log step, its error the "
              "standard error of that fit.");
  kinds_table(report);
  report.figure(matrix_figure(all, false));
  report.figure(slopes_figure(all));
  report.figure(matrix_figure(all, true));
  report.heading("What restores the order");
  cure_table(report, all);
  report.heading("Error control");
  controlled_table(report, all);
  report.heading("Evaluations, the way back, energy");
  trends_table(report, all);
  report.figure(energy_figure(all, {angles.begin(), angles.end()}));
  report.data(numbers(all));
  return report.json();
}

}  // namespace furrow::verification
