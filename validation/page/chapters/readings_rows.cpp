#include "validation/page/chapters/readings_rows.h"

#include <algorithm>
#include <cmath>

#include "output/files.h"
#include "validation/page/chapters/in_words.h"

namespace furrow::validation {
namespace {

using Packings = std::map<std::string, std::vector<Json>>;

// The largest force of scene 3 over the larger of those of scenes 1 and 2. Scene 1 has one packing, which stands beside
// each of the others.
std::vector<Json> last_over_others(const Statement& row, const Packings& said) {
  std::vector<Json> all;
  if (said.size() < 3) return all;
  const auto number = [&](const char* scene, std::size_t p, const char* id) {
    const std::vector<Json>& runs = said.at(scene);
    const Json& run = runs[std::min(p, runs.size() - 1)];
    return run.contains(id) && run[id].is_number() ? run[id].get<double>() : NAN;
  };
  for (std::size_t p = 0; p < said.at("scenario_3").size(); ++p) {
    const double others =
        std::max(number("scenario_1", p, "first_impact"), number("scenario_2", p, "largest_force_discs"));
    const double ratio = number("scenario_3", p, "largest_force_coupled") / others;
    all.push_back(std::isfinite(ratio) ? Json{{row.id, ratio}} : Json{{"failed", "a scene does not run"}});
  }
  return all;
}

std::vector<Json> untorn_of(const Statement& row, const ReadingsFound& found) {
  std::vector<Json> all;
  for (std::size_t k = 0; k < found.untorn.size(); ++k) {
    if (untorn_runs()[k].strength > 1e6) all.push_back({{row.id, is_valid(found.untorn[k]) ? 0.0 : 1.0}});
  }
  return all;
}

// Under the row's own id what its scene says by another row of the same observable.
std::vector<Json> as_another_says(const Statement& row, std::vector<Json> runs) {
  const auto other = std::find_if(the_rows().begin(), the_rows().end(), [&](const Statement& r) {
    return r.scene == row.scene && r.observable == row.observable && r.window == row.window && !is_judged_only(r);
  });
  for (Json& run : runs) {
    if (other != the_rows().end() && run.contains(other->id)) run[row.id] = Json(run[other->id]);
  }
  return runs;
}

}  // namespace

std::vector<Json> runs_of(const Statement& row, const Finalist& finalist, const ReadingsFound& found, AtStep step) {
  const Packings& said = step == AtStep::finer ? finalist.finer : finalist.said;
  if (row.scene == "untorn") return step == AtStep::finer ? std::vector<Json>{} : untorn_of(row, found);
  if (row.scene == "all") return last_over_others(row, said);
  const auto runs = said.find(row.scene);
  if (runs == said.end()) return {};
  return is_judged_only(row) ? as_another_says(row, runs->second) : runs->second;
}

std::string what_runs_do(const Statement& row) {
  return row.scene == "untorn" ? "runs end where the laws hold no longer" : "packings come to their end";
}

std::string rule_of(const Statement& row) {
  if (is_yes_or_no(row)) return "half of the " + what_runs_do(row);
  const std::string unit = row.unit.empty() ? "" : " " + row.unit;
  if (row.holds) {
    const auto [low, high] = *row.holds;
    return "half of the packings " +
           (std::isinf(high)  ? "at " + number(low) + " or more"
            : std::isinf(low) ? "at " + number(high) + " or less"
            : low == high     ? "at " + number(low)
                              : "in " + number(low) + " to " + number(high)) +
           unit;
  }
  if (row.relation == "below" || row.relation == "by")
    return "half of the packings at " + number(row.value) + unit + " or less";
  if (row.relation == "above") return "half of the packings at " + number(row.value) + unit + " or more";
  if (!row.expect.empty()) return "half of the packings say " + row.expect;
  return "the median within a tenth of " + number(row.value) + unit;
}

}  // namespace furrow::validation
