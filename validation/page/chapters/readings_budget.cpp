#include <algorithm>
#include <cmath>

#include "scene/wording.h"
#include "validation/page/chapters/readings_parts.h"
#include "validation/page/names.h"

namespace furrow::validation {
namespace {

bool fails_somewhere(const ReadPoint& point) {
  return std::any_of(point.said.begin(), point.said.end(),
                     [](const auto& said) { return said.second.contains("failed"); });
}

// Mean and spread over packings of the misfit of one scene.
std::string with_spread(const std::vector<Json>& runs, const std::string& scene) {
  double sum = 0, squares = 0;
  const auto n = static_cast<double>(runs.size());
  for (const Json& run : runs) {
    const double misfit = misfit_of({{scene, run}}, {scene});
    sum += misfit;
    squares += misfit * misfit;
  }
  const double variance = std::max(0.0, squares - sum * sum / n);
  return rounded(sum / n, 3) + (n > 1 ? " ± " + rounded(std::sqrt(variance / (n - 1)), 2) : "");
}

// The alternative of which most points fail in some scene: "pull yes", of how many.
std::string failing_most(const ReadingsFound& found) {
  std::string words;
  double most = 0;
  for (std::size_t k = 0; k < the_readings().choices.size(); ++k) {
    const Choice& choice = the_readings().choices[k];
    for (int a = 0; a < std::ssize(choice.alternatives); ++a) {
      double all = 0, failed = 0;
      for (const ReadPoint& point : found.points) {
        if (point.reading[k] != a) continue;
        all += 1;
        failed += fails_somewhere(point) ? 1 : 0;
      }
      if (all < 20 || !(failed / all > most)) continue;
      most = failed / all;
      words = choice.id + " " + choice.alternatives[static_cast<std::size_t>(a)].name + ", " +
              std::to_string(std::lround(100 * most)) + " %";
    }
  }
  return words;
}

}  // namespace

void add_budget(Report& report, const ReadingsFound& found, const Numbers& numbers) {
  double cpu = 0;
  for (const Result& result : numbers.results()) cpu += result.cpu;
  const auto failed = std::count_if(found.points.begin(), found.points.end(), fails_somewhere);
  report.text(
      "All this took " + std::to_string(numbers.results().size()) + " runs and " + rounded(cpu / 3600, 2) +
      " CPU hours. " + std::to_string(failed) + " of the " + std::to_string(found.points.size()) + " points (" +
      std::to_string(std::lround(100.0 * static_cast<double>(failed) / static_cast<double>(found.points.size()))) +
      " %) have a scene that diverges, and there a misfit of 1; the alternative that fails most often is " +
      failing_most(found) + ". None fails always, so all are drawn.");
}

void add_fitted(Report& report, const ReadingsFound& found) {
  if (found.fitted_without.empty()) return;
  std::vector<std::vector<Json>> rows;
  const Finalist& literal = found.finalists.front();
  for (const auto& [out, fitted] : found.fitted_without) {
    std::vector<Json> row{scene_words(out), name_beside(fitted.reading, best_valid_finalist(found).reading)};
    for (const std::string& scene : found.scenes) {
      row.emplace_back(with_spread(fitted.said.at(scene), scene) + (scene == out ? ", held out" : ""));
      row.emplace_back(with_spread(literal.said.at(scene), scene));
    }
    rows.push_back(std::move(row));
  }
  std::vector<std::string> head{"held out", "fitted to the other two"};
  for (const std::string& scene : found.scenes) {
    head.push_back(scene_words(scene));
    head.emplace_back("literal");
  }
  report.table("Misfit of each scene by packings that chose nothing: mean and standard deviation.", head, rows);
}

}  // namespace furrow::validation
