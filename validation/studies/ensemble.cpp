// The paper shows one run of each scene. How much of what it reports is the run's packing? Scenes 2 and 3 over many
// packings; and how few of them suffice to notice that the model has changed.
#include <algorithm>
#include <cmath>
#include <map>

#include "scene/read.h"
#include "validation/studies/few_members.h"
#include "validation/studies/observed_run.h"
#include "validation/studies/studies.h"

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

void add_distributions(Report& report, const std::string& group, const std::vector<Json>& members) {
  std::vector<std::vector<Json>> rows;
  for (const std::string& id : observables_of(group.substr(0, group.find(' ')))) {
    const Sample sample = sample_of(id, members);
    if (sample.numbers.size() < 6) continue;
    const auto [low, high] = sample.median_interval();
    rows.push_back({quantity_of(id), static_cast<int>(sample.numbers.size()), sample.quantile(0.5),
                    three_digits(low) + " to " + three_digits(high),
                    three_digits(sample.quantile(0.05)) + " to " + three_digits(sample.quantile(0.95)),
                    sample.deviation()});
  }
  if (rows.empty()) return;
  report.heading("Scene " + group.substr(9, 1) + "," + group.substr(10) + "s, " + std::to_string(members.size()) +
                 " packings");
  report.table("What the packing alone does to each number. Members in which a thing does not happen say no number.",
               {"number", "members that say it", "median", "95 % interval of the median", "5 % to 95 % of the members",
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

// The norm is of one half of the members; alarms that are false are counted among the other.
Json add_few(Report& report, const std::vector<Json>& members, const std::vector<std::vector<Json>>& changed) {
  const std::vector<Json> half(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2));
  const std::vector<Json> other(members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2), members.end());
  const Norm norm = norm_of(half);
  const double false_alarms = alarm_rate(other, norm, draws);
  report.heading("What a few packings notice");
  std::vector<std::vector<Json>> rows;
  for (std::size_t k = 0; k < changes().size(); ++k) {
    const Change& change = changes()[k];
    const double noticed = alarm_rate(changed[k], norm, draws / 20);
    rows.push_back({change.what, "times " + three_digits(change.factor), 100 * noticed,
                    noticed >= surely             ? "noticed"
                    : noticed <= 2 * false_alarms ? "not noticed"
                                                  : "now and then"});
  }
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
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
               {"changed", "by", "noticed [%]", "so"}, rows);
  return {{"few", few}, {"false_alarms", false_alarms}};
}

}  // namespace

Json ensemble(const Settings& settings) {
  const std::vector<Member> members = paper_members(settings.quick);
  std::vector<Task> tasks;
  for (const Member& m : members)
    tasks.push_back({m.group() + " " + std::to_string(m.seed),
                     [m] { return observed(paper_scene(m.scene, m.reading, m.seed), m.scene); }});
  if (!settings.quick) {
    for (const Change& change : changes()) {
      for (int k = 0; k < changed_members; ++k)
        tasks.push_back({"changed " + change.what + " " + three_digits(change.factor) + " " + std::to_string(k),
                         [&change, k] { return run_changed(change, k); }});
    }
  }
  const std::vector<Json> got = run_tasks("ensemble", settings, tasks);
  std::map<std::string, std::vector<Json>> groups;
  for (std::size_t k = 0; k < members.size(); ++k) groups[members[k].group()].push_back(got[k]);

  Report report(
      "How much is the packing?",
      "Each of the paper's runs has one random packing of the bed. Which of its numbers would another packing "
      "have given too?");
  std::size_t failed = 0;
  std::string why;
  for (const auto& [group, list] : groups) {
    for (const Json& member : list) {
      if (!member.contains("failed")) continue;
      if (++failed == 1) why = member["failed"].get<std::string>();
    }
  }
  report.text(std::to_string(members.size()) + " runs at the paper's step, " + std::to_string(failed) +
              " of them did not come to their end" + (failed == 0 ? "." : "; the first: " + why + "."));
  Json data = {{"members", groups}};
  for (const auto& [group, list] : groups) add_distributions(report, group, list);
  if (!settings.quick) {
    Json blocks = Json::object();
    for (const auto& [group, block, id] : {std::tuple{"scenario_2 disc", "two_disc", "largest_force_discs"},
                                           {"scenario_2 sphere", "two_sphere", "largest_force_discs"},
                                           {"scenario_3 disc", "three_disc", "largest_force_coupled"},
                                           {"scenario_3 sphere", "three_sphere", "largest_force_coupled"}})
      blocks[block] = distribution(sample_of(id, groups[group]));
    report.figure(
        {.name = "ensemble",
         .script = "ensemble.gp",
         .caption =
             "Largest force on the plate over the packings, as distribution functions; the upright lines are the "
             "paper's single runs.",
         .description = "Distribution functions of the largest force for scenes 2 and 3",
         .blocks = blocks});
    std::vector<std::vector<Json>> changed(changes().size());
    for (std::size_t k = members.size(); k < got.size(); ++k)
      changed[(k - members.size()) / changed_members].push_back(got[k]);
    data["few"] = add_few(report, groups["scenario_2 disc"], changed);
  }
  report.data(data);
  report.claim("Every run of the ensemble came to its end.", failed == 0);
  return report.json();
}

}  // namespace furrow::validation
