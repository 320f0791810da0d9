// The order certificate: for each method and each kind of force the errors from which the observed order follows; beside
// it evaluations a step, the way back, and the energy of an undamped oscillator.
#include "verification/studies/order.h"

#include "verification/studies/kept_numbers.h"
#include "verification/studies/order_cure.h"

namespace furrow::verification {
namespace {

std::string observed_key(const std::string& method, const std::string& problem) {
  return "observed/" + method + "/" + problem;
}

std::string trends_key(const std::string& method) { return "trends/" + method; }

std::string cured_key(const std::string& method, const std::string& problem, int grading) {
  return "cured/" + method + "/" + problem + "/" + std::to_string(grading);
}

// What is known of points before they are observed: the steps, or the tolerances.
class Planned {
 public:
  Planned(const std::string& method, const Problem& problem, const Series& series)
      : method_(method), problem_(problem), series_(series), controlled_(make_method(method)->info().controlled) {}
  Point point(std::size_t size) const {
    Point p;
    const int k = static_cast<int>(size);
    (controlled_ ? p.tolerance : p.step) =
        controlled_ ? planned_tolerance(series_, k) : planned_step(method_, problem_, series_, k);
    return p;
  }

 private:
  std::string method_;
  const Problem& problem_;
  Series series_;
  bool controlled_;
};

// Errors; then the step if it is not the planned one, then the number of runs that diverged if any did.
Json to_json(const std::vector<Point>& points, const Planned& planned) {
  Json rows = Json::array();
  for (const Point& p : points) {
    Json row{kept(p.position, 4), kept(p.velocity, 4)};
    if (p.failures > 0 || p.step != planned.point(rows.size()).step) row.push_back(kept(p.step, 6));
    if (p.failures > 0) row.push_back(p.failures);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Point> to_points(const Json& rows, const Planned& planned) {
  std::vector<Point> points;
  if (!rows.is_array()) return points;
  for (const Json& row : rows) {
    Point p = planned.point(points.size());
    p.position = number(row[0]);
    p.velocity = number(row[1]);
    if (row.size() > 2) p.step = number(row[2]);
    if (row.size() > 3) p.failures = row[3].get<int>();
    points.push_back(p);
  }
  return points;
}

Json trends(const MethodInfo& method, const Series& series) {
  const Count count = evaluations(method.name);
  Json json{{"per_step", kept(count.per_step, 5)}, {"at_start", kept(count.at_start, 5)}};
  if (method.controlled) return json;
  json["drift"] = Json::array();
  for (const double angle : drift_angles) json["drift"].push_back(kept(energy_drift(method.name, angle), 6));
  for (const char* name : {"spring", "hertz"}) {
    const Problem& p = problem(name);
    json[name] = to_json(observe_return(method.name, p, series), {method.name, p, series});
  }
  return json;
}

Trends to_trends(const MethodInfo& method, const Json& json, const Series& series) {
  Trends t{{number(json.at("per_step")), number(json.at("at_start"))}, {}, {}, {}};
  if (!json.contains("drift")) return t;
  for (const Json& value : json["drift"]) t.drift.push_back(number(value));
  t.spring = to_points(json.at("spring"), {method.name, problem("spring"), series});
  t.hertz = to_points(json.at("hertz"), {method.name, problem("hertz"), series});
  return t;
}

void add_observed(std::vector<Task>& tasks, const Series& series) {
  for (const MethodInfo& method : method_catalogue()) {
    for (const Problem& p : problems()) {
      if (!applies(method, p)) continue;
      tasks.push_back({observed_key(method.name, p.name), [&method, &p, series] {
                         return to_json(observe(method.name, p, series), {method.name, p, series});
                       }});
    }
    tasks.push_back({trends_key(method.name), [&method, series] { return trends(method, series); }});
  }
}

void add_cured(std::vector<Task>& tasks) {
  for (const char* method : graded_methods) {
    for (const char* name : graded_problems) {
      for (const int grading : gradings)
        tasks.push_back({cured_key(method, name, grading), [method, name, grading] {
                           const Problem& p = problem(name);
                           return to_json(observe_graded(method, p, grading, quick), {method, p, quick});
                         }});
    }
  }
}

}  // namespace

void measure_order(Measurement& measurement) {
  std::vector<Task> tasks;
  add_observed(tasks, order_series(measurement.quick()));
  add_cured(tasks);
  measurement.run(tasks);
}

Observations observations_of(const Numbers& numbers) {
  const Series series = order_series(numbers.quick());
  Observations all;
  for (const MethodInfo& method : method_catalogue()) {
    for (const Problem& p : problems()) {
      if (!applies(method, p)) continue;
      const Cell cell{method.name, p.name};
      all.points[cell] = to_points(numbers.at(observed_key(method.name, p.name)), {method.name, p, series});
      all.verdicts[cell] = verdict(method, p, all.points[cell]);
    }
    const Json& found = numbers.at(trends_key(method.name));
    if (!found.contains("failed")) all.trends[method.name] = to_trends(method, found, series);
  }
  for (const char* method : graded_methods) {
    for (const char* p : graded_problems) {
      for (const int grading : gradings)
        all.cured[{method, p, grading}] =
            to_points(numbers.at(cured_key(method, p, grading)), {method, problem(p), quick});
    }
  }
  return all;
}

}  // namespace furrow::verification
