// The paper shows one run of each scene. Which of its numbers would another packing of the bed have given too, and how
// few packings suffice to notice that the model has changed?
#include "validation/studies/ensemble.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/convergence_settled.h"
#include "validation/page/chapters/in_words.h"
#include "validation/studies/few_members.h"
#include "validation/studies/kept_ensemble.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

constexpr int draws = 20000;
constexpr double surely = 0.95;  // of the draws: what counts as noticed

std::string quantity_of(const std::string& id) {
  if (id == "mean_force") return "Mean force [N]";
  if (id == "surface") return "Height of the settled bed [m]";
  for (const Statement& s : the_paper().statements) {
    if (s.id == id) return s.quantity + (s.unit.empty() ? "" : " [" + s.unit + "]");
  }
  return id;
}

std::vector<std::string> observables_of(const std::string& scene) {
  std::vector<std::string> ids{"surface", "mean_force"};
  for (const Statement& s : the_paper().statements) {
    if (s.scene == scene && s.observable != "finished") ids.push_back(s.id);
  }
  return ids;
}

double without_round_off(double deviation, double median) {
  return deviation < 1e-12 * std::fabs(median) ? 0 : deviation;
}

void add_distributions(Report& report, const std::string& group, const std::vector<Json>& members) {
  std::vector<std::vector<Json>> rows;
  for (const std::string& id : observables_of(group.substr(0, group.find(' ')))) {
    const Sample sample = sample_of(id, members);
    if (sample.numbers.size() < 6) continue;
    const auto [low, high] = sample.median_interval();
    rows.push_back({quantity_of(id), static_cast<int>(sample.numbers.size()), sample.quantile(0.5), from_to(low, high),
                    from_to(sample.quantile(0.05), sample.quantile(0.95)),
                    without_round_off(sample.deviation(), sample.quantile(0.5))});
  }
  if (rows.empty()) return;
  report.heading("Scene " + group.substr(9, 1) + "," + group.substr(10) + "s, " + std::to_string(members.size()) +
                 " packings");
  report.table("What the packing alone does to each number. Runs without the event are left out.",
               {"number", "runs with the event", "median", "95 % interval of the median", "5 % to 95 % of the runs",
                "standard deviation"},
               rows);
}

// Numbers of one observable as a distribution function.
Json distribution(const Sample& sample) {
  Json rows = Json::array();
  for (std::size_t k = 0; k < sample.numbers.size(); ++k)
    rows.push_back({sample.numbers[k], (static_cast<double>(k) + 0.5) / static_cast<double>(sample.numbers.size())});
  return rows;
}

double paper_value(const std::string& id) {
  for (const Statement& s : the_paper().statements) {
    if (s.id == id) return s.value;
  }
  return NAN;
}

Figure figure_of(const Groups& groups) {
  Json blocks = Json::object();
  for (const auto& [group, block, id] : {std::tuple{"scenario_2 disc", "two_disc", "largest_force_discs"},
                                         {"scenario_2 sphere", "two_sphere", "largest_force_discs"},
                                         {"scenario_3 disc", "three_disc", "largest_force_coupled"},
                                         {"scenario_3 sphere", "three_sphere", "largest_force_coupled"}})
    blocks[block] = distribution(sample_of(id, groups.at(group)));
  return {.name = "ensemble",
          .script = "ensemble.gp",
          .caption =
              "Largest force on the plate over the packings, as distribution functions; the upright lines are the "
              "paper's single runs.",
          .description = "Distribution functions of the largest force for scenes 2 and 3",
          .variables = {{"paper_two", paper_value("largest_force_discs")},
                        {"paper_three", paper_value("largest_force_coupled")}},
          .blocks = blocks};
}

std::vector<std::vector<Json>> rows_of_changes(const Numbers& numbers, const Norm& norm, double false_alarms) {
  std::vector<std::vector<Json>> rows;
  for (const Change& change : changes()) {
    std::vector<Json> members;
    for (int k = 0; k < changed_members; ++k) members.push_back(numbers.at(change.key(k)));
    const double noticed = alarm_rate(members, norm, draws / 20);
    rows.push_back({change.what, "times " + three_digits(change.factor), 100 * noticed,
                    noticed >= surely             ? "noticed"
                    : noticed <= 2 * false_alarms ? "not noticed"
                                                  : "now and then"});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  return rows;
}

// The norm is of one half of the members; alarms that are false are counted among the other.
void add_few(Report& report, const Numbers& numbers, const std::vector<Json>& members) {
  const auto middle = members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2);
  const Norm norm = norm_of({members.begin(), middle});
  const double false_alarms = alarm_rate({middle, members.end()}, norm, draws);
  report.heading("What a few packings notice");
  report.text("The regression test runs " + std::to_string(few) +
              " packings of scene 2 that are not in the ensemble and fails if the mean of one of " +
              std::to_string(few_observables.size()) +
              " numbers (height of the settled bed, mean force, largest force, force ratio) lies more than " +
              three_digits(few_limit) +
              " standard errors from the ensemble's. With the norm made of one half of the ensemble, " +
              three_digits(100 * false_alarms) +
              " % of the draws from the other half fail. A packing that does not run to its end fails it always.");
  report.table("How often a change of the model makes it fail, by drawing " + std::to_string(few) + " of " +
                   std::to_string(changed_members) + " packings.",
               {"changed", "by", "noticed [%]", "verdict"}, rows_of_changes(numbers, norm, false_alarms));
}

}  // namespace

Report ensemble(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("ensemble");
  const Groups groups = members_in(numbers);
  Report report(
      "How much does the packing matter?",
      "Each of the paper's runs has one random packing of the bed. Which of its numbers would another packing "
      "have given too?");
  std::size_t runs = 0, failed = 0;
  std::string why;
  for (const auto& [group, list] : groups) {
    runs += list.size();
    for (const Json& member : list) {
      if (member.contains("failed") && ++failed == 1) why = member["failed"].get<std::string>();
    }
  }
  report.text(std::to_string(runs) + " runs by the paper's step, spheres by " + in_ms(step_for_spheres) + ", " +
              std::to_string(failed) + " of them did not come to their end" +
              (failed == 0 ? "." : "; the first: " + why + "."));
  for (const auto& [group, list] : groups) add_distributions(report, group, list);
  if (!numbers.quick()) {
    report.figure(figure_of(groups));
    add_few(report, numbers, groups.at("scenario_2 disc"));
  }
  report.claim({.text = "Every run of the ensemble came to its end.",
                .value = std::to_string(runs - failed) + " of " + std::to_string(runs),
                .aim = "all",
                .holds = failed == 0});
  return report;
}

}  // namespace furrow::validation
