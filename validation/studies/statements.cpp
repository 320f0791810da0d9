// The paper, sentence by sentence: each of its statements judged by the ensemble, and each of its gaps and misprints
// tried both ways.
#include <algorithm>
#include <cmath>
#include <map>

#include "output/files.h"
#include "validation/studies/kept_ensemble.h"
#include "validation/studies/observed_run.h"
#include "validation/studies/studies.h"

namespace furrow::validation {
namespace {

// ---- the verdict on a statement ----

// The range of a number that bears a statement out, if it is one of a limit or of words with a range.
std::optional<std::array<double, 2>> range_of(const Statement& s) {
  if (s.holds) return s.holds;
  if (s.relation == "below" || s.relation == "by") return std::array{-infinity, s.value};
  if (s.relation == "above") return std::array{s.value, infinity};
  return std::nullopt;
}

// Of words in place of a number: that the thing does not happen. Any others leave open what the number is.
bool says_never(const std::string& words) { return words == "not by the end" || words.starts_with("no "); }

constexpr double near = 0.1, alike = 1.0 / 3;  // of the paper's number

std::string by_share(double share) {
  if (std::isnan(share)) return "not testable";
  return share >= 0.5 ? "reproduced" : share >= 0.05 ? "reproduced in kind" : "not reproduced";
}

// A limit is reproduced if at least half of the members keep it, in kind if one in twenty does. A number is reproduced
// if it lies between the 5 % and 95 % quantiles or within a tenth of the median, in kind within a third of it.
std::string verdict_of(const Statement& s, const Sample& sample) {
  if (const auto range = range_of(s)) return by_share(sample.share(*range));
  if (!s.expect.empty()) {
    const auto same = static_cast<double>(std::count(sample.words.begin(), sample.words.end(), s.expect));
    return by_share(same / static_cast<double>(sample.members()));
  }
  if (!std::isfinite(s.value)) return "not testable";
  if (sample.numbers.empty() && std::none_of(sample.words.begin(), sample.words.end(), says_never))
    return "not testable";
  if (2 * sample.numbers.size() < sample.members() || sample.numbers.empty()) return "not reproduced";
  const double off = std::fabs(sample.quantile(0.5) - s.value);
  const bool between =
      sample.numbers.size() >= 20 && s.value >= sample.quantile(0.05) && s.value <= sample.quantile(0.95);
  if (between || off <= near * std::fabs(s.value)) return "reproduced";
  return off <= alike * std::fabs(s.value) ? "reproduced in kind" : "not reproduced";
}

// The words that most members use.
std::string common(const std::vector<std::string>& words) {
  std::string best = "not said";
  std::ptrdiff_t most = 0;
  for (const std::string& w : words) {
    const auto count = std::count(words.begin(), words.end(), w);
    if (count > most) most = count, best = w;
  }
  return best;
}

std::string said(const Statement& s) {
  if (!s.words.empty()) return s.words;
  return s.relation + (s.relation.empty() ? "" : " ") + number(s.value) + (s.unit.empty() ? "" : " " + s.unit);
}

std::string interval(double low, double high, std::size_t members) {
  return members < 6 ? "–" : three_digits(low) + " to " + three_digits(high);
}

// The median with its unit, or what most runs say in words.
std::string ours(const Statement& s, const Sample& sample) {
  if (s.observable == "finished")
    return std::to_string(std::count(sample.numbers.begin(), sample.numbers.end(), 1)) + " of " +
           std::to_string(sample.members()) + " come to their end";
  if (sample.numbers.empty()) return common(sample.words);
  return three_digits(sample.quantile(0.5)) + (s.unit.empty() ? "" : " " + s.unit);
}

// How many runs say it, of how many that were made.
std::string runs(const Sample& sample) {
  const std::size_t said = sample.numbers.empty() ? sample.words.size() : sample.numbers.size();
  const std::size_t all = sample.members() + sample.failed;
  return said == all ? std::to_string(all) : std::to_string(said) + " of " + std::to_string(all);
}

// ---- the ensemble behind the verdicts ----

// Of the ensemble's result in the same directory; where there is none, and in the quick form, run again.
Groups members_in(const Settings& settings) {
  if (!settings.quick && std::filesystem::exists(settings.directory / "ensemble.json"))
    return kept_ensemble(settings.directory);
  const std::vector<Member> members = paper_members(settings.quick);
  std::vector<Task> tasks;
  for (const Member& m : members)
    tasks.push_back({m.group() + " " + std::to_string(m.seed),
                     [m] { return observed(paper_scene(m.scene, m.reading, m.seed), m.scene); }});
  const std::vector<Json> got = run_tasks("statements", settings, tasks);
  Groups groups;
  for (std::size_t k = 0; k < members.size(); ++k) groups[members[k].group()].push_back(got[k]);
  return groups;
}

void judge(Report& report, const Groups& groups) {
  std::vector<std::vector<Json>> rows;
  std::map<std::string, int> count;
  std::size_t missing = 0;
  for (const auto& [group, members] : groups) {
    const std::string scene = group.substr(0, group.find(' '));
    for (const Statement& s : the_paper().statements) {
      if (s.scene != scene) continue;
      const Sample sample = sample_of(s.id, members);
      missing += sample.members() == 0 ? 1 : 0;
      const std::string verdict = verdict_of(s, sample);
      ++count[verdict];
      const auto [low, high] = sample.median_interval();
      rows.push_back({scene == "scenario_1" ? "1" : scene.substr(9) + ", " + group.substr(group.find(' ') + 1) + "s",
                      s.quantity, said(s), ours(s, sample), runs(sample), interval(low, high, sample.numbers.size()),
                      interval(sample.quantile(0.05), sample.quantile(0.95), sample.numbers.size()), verdict});
    }
  }
  std::string counts;
  for (const auto& [verdict, n] : count) counts += (counts.empty() ? "" : ", ") + std::to_string(n) + " " + verdict;
  report.text("Of " + std::to_string(the_paper().statements.size()) + " statements, judged " +
              std::to_string(rows.size()) + " times by scene and reading of the mass: " + counts + ".");
  report.text(
      "A limit, or what is said in words, is reproduced if at least half of the packings keep it, in kind if one in "
      "twenty does. A number is reproduced if it lies between the 5 % and 95 % quantiles of the packings or within a "
      "tenth of their median, in kind within a third of it. A number that no run says is not testable, "
      "one of a thing that does not happen is not reproduced. How words are read as ranges is said in "
      "validation/statements.toml.");
  report.table("Every statement of the paper, judged. Numbers of an ensemble are the median of the runs that say one.",
               {"scene", "statement", "the paper", "ours", "runs", "95 % interval of the median",
                "5 % to 95 % of the packings", "verdict"},
               rows);
  report.claim("Every statement has a number of ours to be judged by.",
               missing == 0 && rows.size() >= the_paper().statements.size());
}

// ---- gaps and misprints ----

struct Gap {
  std::string what, ours, other, key;  // `key`: how a scene file asks for the other reading
  std::string scene;
  std::vector<std::string> shown;  // observables
  void (*change)(Scene&);
};

const std::vector<Gap>& gaps() {
  static const std::vector<Gap> all{
      {"Eq. (2), damper force",
       "along the line, as the text says",
       "whole relative velocity, as printed",
       "lattice.damper = \"full\"",
       "scenario_1",
       {"first_impact", "first_structural_tear"},
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.damper = Damper::full;
       }},
      {"Weight of the lattice",
       "none",
       "5 kg a node",
       "lattice.gravity = true",
       "scenario_1",
       {"first_impact", "first_structural_tear"},
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.gravity = true;
       }},
      {"Tearing",
       "in tension only",
       "by magnitude",
       "lattice.tear = \"magnitude\"",
       "scenario_1",
       {"first_impact", "first_structural_tear"},
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.tear = TearRule::magnitude;
       }},
      {"May a contact pull",
       "no",
       "yes, while it is damped",
       "model.pull = true",
       "scenario_2",
       {"mean_force", "largest_force_discs"},
       [](Scene& s) { s.model.pull = true; }},
      {"Mass of a particle",
       "a disc 1 m deep",
       "a sphere",
       "model.disc_mass = \"sphere\"",
       "scenario_2",
       {"mean_force", "largest_force_discs"},
       [](Scene& s) {
         s.model.disc_mass = DiscMass::sphere;
         s.settle->step = 1e-5;
       }},
      {"Contact of disc and lattice",
       "9 auxiliary points",
       "the exact nearest point",
       "lattice.auxiliary_points = 0",
       "scenario_3",
       {"largest_force_coupled", "first_tear"},
       [](Scene& s) {
         for (Lattice& l : s.lattice) l.auxiliary_points = 0;
       }},
      {"Smoothing of rolling friction",
       "1 rad/s",
       "0.01 rad/s",
       "model.rolling_smoothing = 0.01",
       "scenario_2",
       {"mean_force", "largest_force_discs"},
       [](Scene& s) { s.model.rolling_smoothing = 0.01; }},
      {"Height of the plate in scene 1",
       "0.065 m: three rows",
       "0.075 m: two rows",
       "plate.lower_edge = 0.075",
       "scenario_1",
       {"first_impact", "first_structural_tear"},
       [](Scene& s) { s.plate[0].lower_edge = 0.075; }},
      {"Working depth",
       "0.04 m",
       "0.03 m",
       "plate.working_depth = 0.03",
       "scenario_2",
       {"mean_force", "largest_force_discs"},
       [](Scene& s) { s.plate[0].working_depth = 0.03; }},
  };
  return all;
}

Json shown_in(const Json& run, const std::string& id) {
  if (run.contains(id)) return run[id];
  return run.contains("failed") ? "does not run: " + run["failed"].get<std::string>() : std::string("–");
}

void try_gaps(Report& report, const Settings& settings) {
  std::vector<Task> tasks;
  for (const char* scene : {"scenario_1", "scenario_2", "scenario_3"})
    tasks.push_back({scene, [scene] { return observed(paper_scene(scene, Reading::disc, 1), scene); }});
  std::vector<Gap> tried;
  for (const Gap& gap : gaps()) {
    if (settings.quick && gap.scene != "scenario_1") continue;
    tried.push_back(gap);
    tasks.push_back({gap.key, [gap] {
                       Scene scene = paper_scene(gap.scene, Reading::disc, 1);
                       gap.change(scene);
                       return observed(scene, gap.scene);
                     }});
  }
  if (settings.quick) tasks.erase(tasks.begin() + 1, tasks.begin() + 3);
  const std::vector<Json> got = run_tasks("statements", settings, tasks);
  const std::size_t scenes = settings.quick ? 1 : 3;
  std::vector<std::vector<Json>> rows;
  for (std::size_t k = 0; k < tried.size(); ++k) {
    const Gap& gap = tried[k];
    const Json& ours = got[static_cast<std::size_t>(gap.scene.back() - '1')];
    for (const std::string& id : gap.shown)
      rows.push_back({gap.what, gap.ours, gap.other, gap.key, gap.scene.substr(9), id, shown_in(ours, id),
                      shown_in(got[scenes + k], id)});
  }
  report.heading("Gaps and misprints, tried both ways");
  report.text(
      "Where the paper is silent, contradicts itself or misprints, a key of the scene file takes the other reading; "
      "one packing. The sign printed in Eq. (1) cannot be run, the lattice flies to pieces: that is shown by a page of "
      "the "
      "verification, RigidMotion. All decisions, with their reasons, stand in validation/decisions.md.");
  report.table("", {"point", "furrow's reading", "the other", "key", "scene", "number", "as read", "otherwise"}, rows);
}

}  // namespace

Json statements(const Settings& settings) {
  Report report("The paper, statement by statement",
                "Which of the paper's statements does its model bear out, if scenes 2 and 3 are run over many packings "
                "of the bed instead of one?");
  judge(report, members_in(settings));
  try_gaps(report, settings);
  return report.json();
}

}  // namespace furrow::validation
