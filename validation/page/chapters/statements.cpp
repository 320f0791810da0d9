// The paper, sentence by sentence: which of its statements does the ensemble bear out, and what do its gaps and
// misprints matter?
#include "validation/studies/statements.h"

#include <algorithm>
#include <array>
#include <map>

#include "output/files.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/convergence_settled.h"
#include "validation/page/chapters/in_words.h"
#include "validation/page/chapters/statements_why.h"
#include "validation/page/names.h"
#include "validation/studies/kept_ensemble.h"
#include "validation/studies/observed_run.h"
#include "validation/studies/verdict.h"

namespace furrow::validation {
namespace {

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

std::string interval(double low, double high, std::size_t members) { return members < 6 ? "–" : from_to(low, high); }

// The median with its unit, or what most runs say in words.
std::string ours(const Statement& s, const Sample& sample) {
  if (is_yes_or_no(s)) return count_of_yes(sample) + " come to their end";
  if (sample.numbers.empty()) return common(sample.words);
  return three_digits(sample.quantile(0.5)) + (s.unit.empty() ? "" : " " + s.unit);
}

// How many runs say it, of how many that were made.
std::string runs(const Sample& sample) {
  const std::size_t said = sample.numbers.empty() ? sample.words.size() : sample.numbers.size();
  const std::size_t all = sample.members() + sample.failed;
  return said == all ? std::to_string(all) : std::to_string(said) + " of " + std::to_string(all);
}

// Where the members are: those of the ensemble, in the quick form a few of its own.
const Numbers& with_members(const Shelf& shelf) {
  if (shelf.of("statements").quick()) return shelf.of("statements");
  try {
    const Numbers& numbers = shelf.of("ensemble");
    if (const std::string why = unusable_ensemble(numbers); !why.empty()) throw FileError("the kept ensemble " + why);
    return numbers;
  } catch (const FileError& error) {
    throw FileError(error.what() + std::string("; the statements are judged by it; make it by: furrow study ensemble"));
  }
}

void judge(Report& report, const Groups& groups, const Reasons& reasons) {
  std::vector<std::vector<Json>> rows;
  std::map<std::string, int> count;
  std::map<std::string, std::array<int, 2>> of_reading;  // of scenes 2 and 3: reproduced, all
  std::size_t missing = 0;
  for (const auto& [group, members] : groups) {
    const std::string scene = group.substr(0, group.find(' '));
    for (const Statement& s : the_paper().statements) {
      if (s.scene != scene) continue;
      const Sample sample = sample_of(s.id, members);
      missing += sample.members() == 0 ? 1 : 0;
      const std::string verdict = verdict_of(s, sample);
      ++count[verdict];
      if (scene != "scenario_1") {
        std::array<int, 2>& one = of_reading[group.substr(group.find(' ') + 1) + "s"];
        one[0] += verdict == "reproduced" ? 1 : 0;
        ++one[1];
      }
      const auto [low, high] = sample.median_interval();
      const std::size_t numbers = is_yes_or_no(s) ? 0 : sample.numbers.size();  // those have no median
      rows.push_back(
          {scene == "scenario_1" ? "scene 1" : scene_words(scene) + ", " + group.substr(group.find(' ') + 1) + "s",
           statement_cell(s, group), verdict, paper_cell(s, said(s)), ours(s, sample), runs(sample),
           interval(low, high, numbers), interval(sample.quantile(0.05), sample.quantile(0.95), numbers),
           reasons.why(s, sample, group, verdict)});
    }
  }
  std::string counts;
  for (const auto& [verdict, n] : count) counts += (counts.empty() ? "" : ", ") + std::to_string(n) + " " + verdict;
  std::string readings;
  for (const auto& [reading, n] : of_reading)
    readings += (readings.empty() ? "" : ", ") + reading + " " + std::to_string(n[0]) + " of " + std::to_string(n[1]);
  report.headline({.tile = "paper",
                   .value = std::to_string(count["reproduced"]) + " of " + std::to_string(rows.size()),
                   .text = "judgements of its " + std::to_string(the_paper().statements.size()) +
                           " statements reproduce them (in scenes 2 and 3: " + readings + "), " +
                           std::to_string(count["reproduced in kind"]) + " in kind, " +
                           std::to_string(count["not reproduced"]) + " do not."});
  report.text("Of " + std::to_string(the_paper().statements.size()) + " statements, judged " +
              std::to_string(rows.size()) + " times by scene and reading of the mass: " + counts +
              ". Discs are judged at the paper's step. Spheres are judged at " + in_ms(step_for_spheres) +
              ", for the paper's is not stable for them" + reasons.spheres_at_the_papers_step() + ".");
  report.text(
      "A limit, or what is said in words, is reproduced if at least half of the packings keep it, in kind if one in "
      "twenty does. A number is reproduced if the median of the packings is within a tenth of it, or if it lies "
      "between their 5 % and 95 % quantiles and at least 20 of them say one; in kind if the median is within a third "
      "of it. A number that no run says is not testable, one of a thing that does not happen is not reproduced. How "
      "words are read as ranges is said in validation/statements.toml.");
  report.table("Every statement of the paper, judged. Numbers of an ensemble are the median of the runs that say one.",
               {"scene", "statement", "verdict", "the paper", "ours", "runs", "95 % interval of the median",
                "5 % to 95 % of the packings", "why not"},
               rows);
  report.claim({.text = "Every statement has a number of ours to be judged by.",
                .value = std::to_string(rows.size() - missing) + " of " + std::to_string(rows.size()),
                .aim = "all, at least one for each of the paper's " + std::to_string(the_paper().statements.size()),
                .holds = missing == 0 && rows.size() >= the_paper().statements.size()});
}

// ---- gaps and misprints ----

struct Readings {
  std::string what, ours, other;
};

// By the setting of a scene file that asks for the other reading.
const std::map<std::string, Readings>& readings() {
  static const std::map<std::string, Readings> all{
      {"lattice.damper = \"full\"",
       {"Eq. (2), damper force", "along the line, as the text says", "whole relative velocity, as printed"}},
      {"lattice.gravity = true", {"Weight of the lattice", "none", "5 kg a node"}},
      {"lattice.tear = \"magnitude\"", {"Tearing", "in tension only", "by magnitude"}},
      {"model.pull = true", {"May a contact pull", "no", "yes, while it is damped"}},
      {"model.disc_mass = \"sphere\", time.step = 5e-6",
       {"Mass of a particle", "a disc 1 m deep", "a sphere, at a step that is stable"}},
      {"lattice.auxiliary_points = 0",
       {"Contact of disc and lattice", "9 auxiliary points", "the exact nearest point"}},
      {"model.rolling_smoothing = 0.01", {"Smoothing of rolling friction", "1 rad/s", "0.01 rad/s"}},
      {"plate.lower_edge = 0.075", {"Height of the plate in scene 1", "0.065 m: three rows", "0.075 m: two rows"}},
      {"plate.working_depth = 0.03", {"Working depth", "0.04 m", "0.03 m"}},
  };
  return all;
}

Json shown_in(const Json& run, const std::string& id) {
  if (run.contains(id)) return run[id];
  return run.contains("failed") ? "does not run" : "–";
}

std::string quantity_of(const std::string& id) {
  if (id == "mean_force") return "Mean force [N]";
  for (const Statement& s : the_paper().statements) {
    if (s.id == id) return s.quantity + (s.unit.empty() ? "" : " [" + s.unit + "]");
  }
  return id;
}

// As read: the first packing of the members.
void add_gaps(Report& report, const Numbers& numbers, const Groups& groups) {
  std::vector<std::vector<Json>> rows;
  std::string failures;
  for (const Gap& gap : gaps(numbers.quick())) {
    const Readings& words = readings().at(gap.setting);
    const Json &as_read = groups.at(gap.scene + " disc").at(0), &otherwise = numbers.at(gap.key());
    for (const std::string& id : gap.shown)
      rows.push_back({words.what, words.ours, words.other, gap.setting, scene_words(gap.scene), quantity_of(id),
                      shown_in(as_read, id), shown_in(otherwise, id)});
    if (otherwise.contains("failed"))
      failures += " With " + gap.setting + " " + scene_words(gap.scene) +
                  " does not run: " + otherwise["failed"].get<std::string>() + ".";
  }
  report.heading("Gaps and misprints, tried both ways");
  report.text(
      "Where the paper is silent, contradicts itself or misprints, a key of the scene file takes the other reading; "
      "one packing. The sign printed in Eq. (1) cannot be run, the lattice flies to pieces: that is shown by a page of "
      "the verification, RigidMotion. All decisions, with their reasons, stand in validation/decisions.md.");
  if (!failures.empty()) report.text(failures.substr(1));
  report.table("The numbers with furrow's reading and with the other.",
               {"point", "furrow's reading", "the other", "key", "scene", "number", "as read", "otherwise"}, rows);
}

}  // namespace

Report statements(const Shelf& shelf) {
  Report report("The paper, statement by statement",
                "Which of the paper's statements does its model bear out, if scenes 2 and 3 are run over many packings "
                "of the bed instead of one?");
  const Groups groups = members_in(with_members(shelf));
  judge(report, groups, Reasons(shelf));
  add_gaps(report, shelf.of("statements"), groups);
  return report;
}

}  // namespace furrow::validation
