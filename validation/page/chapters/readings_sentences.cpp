#include <algorithm>

#include "scene/wording.h"
#include "validation/page/chapters/readings_parts.h"

namespace furrow::validation {

void add_sentences(Report& report, const ReadingsFound& found) {
  const Judgement literal = judge(found.finalists.front(), found.scenes);
  const Judgement best = judge(best_valid_finalist(found), found.scenes);
  std::vector<std::vector<Json>> rows;
  for (std::size_t k = 0; k < the_sentences().size(); ++k) {
    const Sentence& sentence = the_sentences()[k];
    std::string values;
    for (const std::string& id : sentence.rows)
      values += (values.empty() ? "" : "; ") + said_of(best_valid_finalist(found), id);
    rows.push_back({sentence.text, sentence.where, sentence.untested.empty() ? values : sentence.untested,
                    literal.sentences[k], best.sentences[k]});
  }
  report.heading("Every sentence");
  report.text(
      "Verdicts are computed from the rows of a sentence, the worst of them counts: reproduced and reproduced in kind "
      "as in the chapter on statements; only at this step, where the finer step takes that away; contradicted by the "
      "paper itself, where a figure and the text leave no number that keeps both; not testable, where there is no "
      "row.");
  report.table("Sentences of the paper; ours: medians of the winner.",
               {"the paper", "where", "ours", "literal reading", "the winner"}, rows);
}

// For each row that the winner does not reproduce: the closest that any reading comes, and what that one loses.
void add_trade_offs(Report& report, const ReadingsFound& found) {
  const Judgement best = judge(best_valid_finalist(found), found.scenes);
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
                    name_beside(closest->reading, best_valid_finalist(found).reading), closest->misfit(found.scenes),
                    closest->misfit(found.scenes) - least});
  }
  report.heading("What is not reached");
  report.table(
      "Rows that the winner does not reproduce: the closest that any reading tried comes, valid or not, with its "
      "misfit "
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

}  // namespace furrow::validation
