#include "verification/studies/published.h"

#include <algorithm>

#include "verification/studies/kept_numbers.h"
#include "verification/studies/published_table.h"

namespace furrow::verification {
namespace {

Json to_json(const MethodInfo& method, const PublishedProblem& problem) {
  const PublishedCell cell = published_cell(method, problem);
  if (!cell.cannot.empty()) return {{"cannot", cell.cannot}};
  const auto finest = std::min_element(cell.points.begin(), cell.points.end(),
                                       [](const Point& a, const Point& b) { return a.position < b.position; });
  return {{"slope", cell.at_floor || cell.few_steps ? Json() : kept(cell.slope.value, 4)},
          {"error", kept(finest->position, 3)},
          {"holds", cell.holds},
          {"known", known_to_fail(method, problem)}};
}

}  // namespace

std::string published_key(const MethodInfo& method, const PublishedProblem& problem) {
  return method.name + ", " + problem.name;
}

void measure_published(Measurement& measurement) {
  std::vector<Task> tasks;
  for (const MethodInfo& method : method_catalogue()) {
    for (const PublishedProblem& problem : published_problems())
      tasks.push_back({published_key(method, problem), [&method, &problem] { return to_json(method, problem); }});
  }
  measurement.run(tasks);
}

}  // namespace furrow::verification
