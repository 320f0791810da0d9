// The paper read again: what its open choices matter, which reading comes closest, and every sentence judged.
#include <algorithm>
#include <cmath>

#include "scene/wording.h"
#include "validation/page/chapters/chapters.h"
#include "validation/page/chapters/names.h"
#include "validation/page/chapters/readings_parts.h"
#include "validation/studies/reading_search.h"

namespace furrow::validation {
namespace {

void add_search(Report& report, const ReadingsFound& found) {
  report.text(
      std::to_string(found.points.size()) +
      " readings were run at the paper's step with one packing: the literal "
      "one, " +
      std::to_string(found.alone) + " with one choice changed, " + std::to_string(found.random) + " drawn at random, " +
      std::to_string(found.exchanged) +
      " by exchange of one choice after the other. The misfit of "
      "a reading, 0 to 1, is a root of mean squares over the sentences, each of which counts once; it was stated in "
      "validation/sentences.toml before the search.");
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
  const Interpretation& winner = best_finalist(found).reading;
  for (const Finalist& finalist : found.finalists) {
    const Judgement judged = judge(finalist, found.scenes);
    std::vector<Json> row{name_beside(finalist.reading, winner), judged.misfit, judged.finer_misfit};
    for (const std::string& verdict : counted_verdicts()) row.emplace_back(count_of(judged.sentences, verdict));
    row.emplace_back(judged.older_reproduced);
    rows.push_back(std::move(row));
  }
  std::vector<std::string> head{"reading", "misfit, paper's step", "misfit, finer step"};
  head.insert(head.end(), counted_verdicts().begin(), counted_verdicts().end());
  head.emplace_back("of the 41 older statements reproduced");
  report.heading("The best readings, judged by packings that did not choose them");
  report.table("Mean misfit over " + std::to_string(the_readings().packings) + " packings; the finer step is " +
                   rounded(the_readings().fine_step, 3) + " s. Counts are of sentences.",
               head, rows);
}

// Whether the winner is to be the reading of the scene files, by the rule that was stated before the search.
void claim_default(Report& report, const ReadingsFound& found, const Judgement& winner, const Judgement& literal) {
  if (found.scenes.size() < 3) return;
  int held_out = 0;
  for (const std::string& out : found.scenes)
    held_out += found.best(found.others(out)).misfit({out}) < found.points.front().misfit({out}) ? 1 : 0;
  const bool wins = winner.misfit < literal.misfit && winner.finer_misfit < literal.finer_misfit &&
                    held_out == std::ssize(found.scenes);
  const auto beside = [](double ours, double of_literal) {
    return rounded(ours, 3) + " (literal: " + rounded(of_literal, 3) + ")";
  };
  report.claim(
      {.text =
           "Misfit of the winning reading at the paper's step; " + beside(winner.finer_misfit, literal.finer_misfit) +
           " at a finer one; what two scenes choose has less than the literal one on the third for " +
           std::to_string(held_out) + " of " + std::to_string(found.scenes.size()) + " scenes. " +
           (wins ? "By the rule the winning reading is to be that of the scene files, which still have the literal one."
                 : "So by the rule the scene files keep the literal one."),
       .value = beside(winner.misfit, literal.misfit),
       .aim = "the scene files have the reading that wins",
       .holds = !wins});
}

// Chosen by two scenes, asked for the third.
void add_held_out(Report& report, const ReadingsFound& found) {
  if (found.scenes.size() < 3) return;
  std::vector<std::vector<Json>> rows;
  for (const std::string& out : found.scenes) {
    const std::vector<std::string> in = found.others(out);
    const ReadPoint &best = found.best(in), &literal = found.points.front();
    rows.push_back({scene_words(out), name_beside(best.reading, best_finalist(found).reading), rows_near(best, in),
                    rows_near(literal, in), rows_near(best, {out}), rows_near(literal, {out}), best.misfit({out}),
                    literal.misfit({out})});
  }
  report.heading("Held out");
  report.table(
      "The reading that two scenes choose, asked for the third: rows whose misfit is below one half, in and out of "
      "the sample.",
      {"held out", "chosen by the other two", "rows, the two", "literal", "rows, held out", "literal",
       "misfit, held out", "literal"},
      rows);
}

void add_sentences(Report& report, const ReadingsFound& found) {
  const Judgement literal = judge(found.finalists.front(), found.scenes);
  const Judgement best = judge(best_finalist(found), found.scenes);
  std::vector<std::vector<Json>> rows;
  for (std::size_t k = 0; k < the_sentences().size(); ++k) {
    const Sentence& sentence = the_sentences()[k];
    std::string values;
    for (const std::string& id : sentence.rows)
      values += (values.empty() ? "" : "; ") + said_of(best_finalist(found), id);
    rows.push_back({sentence.text, sentence.where, sentence.untested.empty() ? values : sentence.untested,
                    literal.sentences[k], best.sentences[k]});
  }
  report.heading("Every sentence");
  report.text(
      "Verdicts are computed from the rows of a sentence, the worst of them counts: reproduced and reproduced in kind "
      "as in the chapter on statements; only at this step, where the finer step takes that away; contradicted by the "
      "paper itself, where a figure and the text leave no number that keeps both; not testable, where there is no "
      "row.");
  report.table("Sentences of the paper; ours: medians of the reading that wins at both steps.",
               {"the paper", "where", "ours", "literal reading", "winning reading"}, rows);
}

// For each row that the winner does not reproduce: the closest that any reading comes, and what that one loses.
void add_trade_offs(Report& report, const ReadingsFound& found) {
  const Judgement best = judge(best_finalist(found), found.scenes);
  const double least = found.best(found.scenes).misfit(found.scenes);
  std::vector<std::vector<Json>> rows;
  for (const Statement& row : the_rows()) {
    const auto verdict = best.rows.find(row.id);
    if (verdict == best.rows.end() || verdict->second != "not reproduced") continue;
    const auto closest =
        std::min_element(found.points.begin(), found.points.end(), [&](const ReadPoint& a, const ReadPoint& b) {
          return row_misfit(row, a.said.at(row.scene)) < row_misfit(row, b.said.at(row.scene));
        });
    rows.push_back({row.quantity, wanted_of(row), said_in(closest->said.at(row.scene), row.id),
                    name_beside(closest->reading, best_finalist(found).reading), closest->misfit(found.scenes),
                    closest->misfit(found.scenes) - least});
  }
  report.heading("What is not reached");
  report.table(
      "Rows that the winning reading does not reproduce: the closest that any reading tried comes, with its misfit "
      "over all sentences and what that is above the least.",
      {"row", "the paper", "closest", "by", "its misfit", "above the least"}, rows);
}

void add_untorn(Report& report, const ReadingsFound& found) {
  std::vector<std::vector<Json>> rows;
  int unstable = 0, untorn = 0;
  for (std::size_t k = 0; k < found.untorn.size(); ++k) {
    const Untorn run = untorn_runs()[k];
    const Json& gave = found.untorn[k];
    const bool valid = gave.value("valid", false);
    if (run.strength > 1e6) untorn += 1, unstable += valid ? 0 : 1;
    rows.push_back({run.strength > 1e6 ? Json("never tears") : Json(run.strength), run.step,
                    valid ? "valid" : "invalid", Json(gave.contains("failed") ? gave["failed"] : gave["reason"]),
                    gave.value("reached", Json()), gave.value("torn", Json())});
  }
  report.heading("Without deleting the connections");
  report.text(
      "The paper says that without deleting the connections the stability of its first simulation was not adequate. "
      "Links that never tear: " +
      std::to_string(unstable) + " of " + std::to_string(untorn) + " steps end where the laws hold no longer.");
  report.table("Scene 1 with other strengths, watched as furrow run does it.",
               {"strength [N]", "step [s]", "validity", "why", "reached [mm]", "links torn"}, rows);
}

}  // namespace

Report readings_of_the_paper(const Shelf& shelf) {
  const Numbers& numbers = shelf.of("readings");
  const ReadingsFound found = search_readings(
      [&](const std::vector<Task>& tasks) {
        std::vector<Json> values;
        for (const Task& task : tasks) values.push_back(numbers.at(task.key));
        return values;
      },
      numbers.quick());
  Report report("The paper read again",
                "Which reading of what the paper leaves open comes closest to all that it says?");
  const Finalist& best = best_finalist(found);
  const Judgement winner = judge(best, found.scenes), literal = judge(found.finalists.front(), found.scenes);
  report.claim({.text = "Sentences with rows that the winning reading (" + name_of(best.reading) +
                        ") reproduces; the literal one " + std::to_string(count_of(literal.sentences, "reproduced")) +
                        ".",
                .value = std::to_string(count_of(winner.sentences, "reproduced")) + " of " + std::to_string(testable()),
                .aim = "more than the literal one",
                .holds = count_of(winner.sentences, "reproduced") > count_of(literal.sentences, "reproduced")});
  claim_default(report, found, winner, literal);
  add_search(report, found);
  add_finalists(report, found);
  add_held_out(report, found);
  add_sentences(report, found);
  add_trade_offs(report, found);
  add_untorn(report, found);
  return report;
}

}  // namespace furrow::validation
