// The paper read again: what its open choices matter, which reading comes closest, and every sentence judged.
#include <algorithm>
#include <cmath>

#include "scene/wording.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/readings_parts.h"
#include "validation/page/names.h"
#include "validation/studies/reading_search.h"

namespace furrow::validation {
namespace {

void add_search(Report& report, const ReadingsFound& found, const Numbers& numbers) {
  const std::size_t valid = found.joint - 1 - found.alone - found.random - found.exchanged;
  report.text(
      std::to_string(found.points.size()) +
      " readings were run at the paper's step with one packing: the literal one, " + std::to_string(found.alone) +
      " with one choice changed, " + std::to_string(found.random) + " drawn at random, " +
      std::to_string(found.exchanged) + " by exchange of one choice after the other from the best of them, " +
      std::to_string(valid) +
      " in the same way from the best valid one. A reading is valid if furrow run brings its three scenes to their "
      "ends with what the literal scene files allow, and no more; the best valid one is the winner. The misfit of a "
      "reading, 0 to 1, is a root of mean squares over the sentences, each of which counts once; it was stated in "
      "validation/sentences.toml before the first search and is not changed since. That exchanges also begin at the "
      "best "
      "valid point came after the first look at the points.");
  add_budget(report, found, numbers);
  std::vector<std::vector<Json>> rows;
  const double literal = found.points.front().misfit(found.scenes);
  for (std::size_t k = 1; k <= found.alone; ++k)
    rows.push_back({words_of(found.points[k].reading), found.points[k].misfit(found.scenes),
                    found.points[k].misfit(found.scenes) - literal});
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return a[2].template get<double>() < b[2].template get<double>();
  });
  report.table("What one choice alone changes; the literal reading has a misfit of " + rounded(literal, 3) + ".",
               {"choice", "misfit", "change"}, rows);
  std::string left;
  for (const auto& [open, why] : the_readings().unsearched) left += " " + open + " (" + why + ").";
  report.text("Open, and not searched:" + left);
}

void add_finalists(Report& report, const ReadingsFound& found) {
  std::vector<std::vector<Json>> rows;
  const Interpretation& winner = best_valid_finalist(found).reading;
  for (const Finalist& finalist : found.finalists) {
    const Judgement judged = judge(finalist, found);
    std::vector<Json> row{name_beside(finalist.reading, winner), finalist.valid_runs(), judged.misfit,
                          judged.finer_misfit};
    for (const std::string& verdict : counted_verdicts()) row.emplace_back(count_of(judged.sentences, verdict));
    row.emplace_back(judged.older_reproduced);
    rows.push_back(std::move(row));
  }
  std::vector<std::string> head{"reading", "valid runs, of " + std::to_string(watched_runs(found)),
                                "misfit, paper's step", "misfit, finer step"};
  head.insert(head.end(), counted_verdicts().begin(), counted_verdicts().end());
  head.emplace_back("of the 41 older statements reproduced");
  report.heading("The best readings, judged by packings that did not choose them");
  report.table("The literal reading, the best of all and the best valid ones. Mean misfit over " +
                   std::to_string(the_readings().packings) + " packings; the finer step is " +
                   rounded(1e3 * the_readings().fine_step, 3) +
                   " ms. Valid runs: those that furrow run brings to their end, at the paper's step. Counts are of "
                   "sentences.",
               head, rows);
}

std::string beside_literal(double ours, double of_literal) {
  return rounded(ours, 3) + " (literal: " + rounded(of_literal, 3) + ")";
}

// Whether the winner is to be the reading of the scene files, and whether it is.
void claim_default(Report& report, const ReadingsFound& found, const Judgement& winner, const Judgement& literal) {
  if (found.scenes.size() < 3) return;
  const ReadPoint& by_the_letter = found.points.front();
  int held_out = 0;
  for (const std::string& out : found.scenes)
    held_out += found.at(found.valid_without.at(out)).misfit({out}) < by_the_letter.misfit({out}) ? 1 : 0;
  const bool wins = winner.misfit < literal.misfit && winner.finer_misfit < literal.finer_misfit &&
                    held_out == std::ssize(found.scenes);
  const Interpretation& due = wins ? best_valid_finalist(found).reading : by_the_letter.reading;
  report.claim({.text = "Misfit of the winner at the paper's step; " +
                        beside_literal(winner.finer_misfit, literal.finer_misfit) +
                        " at a finer one; what two scenes choose has less than the literal reading on the third for " +
                        std::to_string(held_out) + " of " + std::to_string(found.scenes.size()) +
                        " scenes. So by the rule the scene files are to have " +
                        (wins ? "the winner." : "the literal reading."),
                .value = beside_literal(winner.misfit, literal.misfit),
                .aim = "the scene files have the reading that the rule gives them",
                .holds = is_of_the_scene_files(due, found.scenes)});
}

// The reading of least misfit, if it is not valid.
void add_invalid_winner(Report& report, const ReadingsFound& found) {
  const Finalist& least = best_finalist(found);
  if (least.reading == best_valid_finalist(found).reading) return;
  std::string why;
  for (const auto& [scene, runs] : least.watched) {
    for (const Json& run : runs) {
      if (why.empty() && !is_valid(run))
        why = scene_words(scene) + ": " + run.value("reason", run.value("failed", std::string("it does not run")));
    }
  }
  const Judgement judged = judge(least, found);
  report.text("The least misfit of all, " + rounded(judged.misfit, 3) + " at the paper's step and " +
              rounded(judged.finer_misfit, 3) + " at the finer one, has " +
              name_beside(least.reading, best_valid_finalist(found).reading) + ". It reproduces " +
              std::to_string(count_of(judged.sentences, "reproduced")) +
              " sentences, and is no reading of the scene files: furrow run brings " +
              std::to_string(least.valid_runs()) + " of its " + std::to_string(watched_runs(found)) +
              " runs to their end. " + why.substr(0, why.find(". ")) + ".");
}

// Chosen by two scenes, asked for the third: among the valid readings, and among all.
void add_held_out(Report& report, const ReadingsFound& found) {
  if (found.scenes.size() < 3) return;
  std::vector<std::vector<Json>> rows;
  const ReadPoint& literal = found.points.front();
  const auto add = [&](const std::string& out, const char* among, const ReadPoint& chosen) {
    const std::vector<std::string> in = found.others(out);
    rows.push_back({scene_words(out), among, name_beside(chosen.reading, best_valid_finalist(found).reading),
                    rows_near(chosen, in), rows_near(literal, in), rows_near(chosen, {out}), rows_near(literal, {out}),
                    chosen.misfit({out}), literal.misfit({out})});
  };
  for (const std::string& out : found.scenes) add(out, "valid", found.at(found.valid_without.at(out)));
  for (const std::string& out : found.scenes) add(out, "all", found.best(found.others(out)));
  report.heading("Held out");
  report.text(
      found.form == SearchForm::first
          ? "The kept numbers are of the search's first form: what two scenes choose is chosen among points to "
            "which exchanges by all three scenes have led, with one packing. So these rows are no fair test of "
            "overfitting; they favour the chosen reading."
          : "Each two scenes have exchanges of their own, from the points that no misfit led to, and what they "
            "choose is valid where these two are; the third took no part. Misfits by packings that chose nothing "
            "stand in the second table.");
  report.table(
      "The reading that two scenes choose, among the valid ones and among all, asked for the third: rows whose misfit "
      "is "
      "below one half, in and out of the sample.",
      {"held out", "among", "chosen by the other two", "rows, the two", "literal", "rows, held out", "literal",
       "misfit, held out", "literal"},
      rows);
  add_fitted(report, found);
}

}  // namespace

Report readings_of_the_paper(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("readings");
  const ReadingsFound found = kept_search(numbers);
  Report report("The paper read again",
                "Which reading of what the paper leaves open comes closest to all that it says?");
  const Finalist& best = best_valid_finalist(found);
  const Judgement winner = judge(best, found), literal = judge(found.finalists.front(), found);
  report.claim({.text = "Sentences with rows that the winner (" + name_of(best.reading) +
                        ") reproduces; the literal one " + std::to_string(count_of(literal.sentences, "reproduced")) +
                        ".",
                .value = std::to_string(count_of(winner.sentences, "reproduced")) + " of " + std::to_string(testable()),
                .aim = "more than the literal one",
                .holds = count_of(winner.sentences, "reproduced") > count_of(literal.sentences, "reproduced")});
  claim_default(report, found, winner, literal);
  add_search(report, found, numbers);
  add_finalists(report, found);
  add_invalid_winner(report, found);
  add_held_out(report, found);
  add_sentences(report, found);
  add_trade_offs(report, found);
  add_untorn(report, found);
  return report;
}

}  // namespace furrow::validation
