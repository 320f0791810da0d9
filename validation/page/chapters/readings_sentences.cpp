#include <algorithm>
#include <cmath>

#include "scene/wording.h"
#include "validation/page/chapters/readings_parts.h"
#include "validation/page/chapters/readings_rows.h"
#include "validation/page/names.h"
#include "validation/studies/reading_runs.h"

namespace furrow::validation {
namespace {

std::string verdict_in(const Judgement& judged, std::size_t sentence) {
  const std::string &verdict = judged.sentences[sentence], &by_rows = judged.by_rows[sentence];
  return verdict == by_rows ? verdict : verdict + "; its rows: " + by_rows;
}

// Rows of other scenes and sentences that one point is near and the other is not.
std::string lost(const ReadPoint& by, const ReadPoint& winner, const std::vector<std::string>& scenes) {
  std::string words;
  int more = 0, named = 0;
  for (const Statement& row : the_rows()) {
    if (is_judged_only(row) || std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) continue;
    if (row_misfit(row, winner.said.at(row.scene)) >= 0.5 || row_misfit(row, by.said.at(row.scene)) < 0.5) continue;
    if (++named > 3) {
      ++more;
      continue;
    }
    words += (words.empty() ? "" : "; ") + row.quantity + " (" + scene_words(row.scene) +
             "): " + said_in(by.said.at(row.scene), row.id) + " for " + wanted_of(row);
  }
  return words.empty() ? "nothing" : words + (more > 0 ? "; " + std::to_string(more) + " more" : "");
}

// Two numbers of one scene that no reading is near at once, and the reading that is nearest to both.
void add_pair(Report& report, const ReadingsFound& found, const std::string& one, const std::string& other) {
  const Statement &a = row_named(one), &b = row_named(other);
  const auto misfit = [&](const ReadPoint& p) {
    return row_misfit(a, p.said.at(a.scene)) + row_misfit(b, p.said.at(b.scene));
  };
  const auto best = std::min_element(found.points.begin(), found.points.end(),
                                     [&](const ReadPoint& x, const ReadPoint& y) { return misfit(x) < misfit(y); });
  report.text(a.quantity + " and " + b.quantity + ", " + wanted_of(a) + " and " + wanted_of(b) +
              ", at once: nearest to both comes " + said_in(best->said.at(a.scene), one) + " and " +
              said_in(best->said.at(b.scene), other) + ", with " + name_of(concerning(best->reading, a.scene)) +
              "; its misfit over all sentences is " + rounded(best->misfit(found.scenes), 3) + ".");
}

}  // namespace

void add_sentences(Report& report, const ReadingsFound& found) {
  const Judgement literal = judge(found.finalists.front(), found);
  const Judgement best = judge(best_valid_finalist(found), found);
  std::vector<std::vector<Json>> rows;
  for (std::size_t k = 0; k < the_sentences().size(); ++k) {
    const Sentence& sentence = the_sentences()[k];
    std::string values, rules;
    for (const std::string& id : sentence.rows) {
      values += (values.empty() ? "" : "; ") + said_of(best_valid_finalist(found), found, id);
      rules += (rules.empty() ? "" : "; ") + rule_of(row_named(id));
    }
    rows.push_back({sentence.text, sentence.where, rules.empty() ? Json() : Json(rules),
                    sentence.untested.empty() ? values : sentence.untested, verdict_in(literal, k),
                    verdict_in(best, k)});
  }
  report.heading("Every sentence");
  report.text(
      "Verdicts are computed from the rows of a sentence, the worst of them counts: reproduced and reproduced in kind "
      "as in the chapter on statements; only at this step, where the finer step takes that away; contradicted by the "
      "paper itself, where a figure and the text leave no number that keeps both, with what its rows come to; not "
      "testable, where there is no row. Half of the packings that keep a rule reproduce, one in twenty does so in "
      "kind; "
      "a number is reproduced in kind within a third. The literal reading is not free of the paper's numbers: the "
      "height of its plate in scene 1 was chosen by the free flight and the first tear.");
  report.table("Sentences of the paper; ours: medians of the winner.",
               {"the paper", "where", "rule", "ours", "literal reading", "the winner"}, rows);
}

// For each row that the winner does not reproduce: the closest that any reading comes, and what that one loses.
void add_trade_offs(Report& report, const ReadingsFound& found) {
  const Judgement best = judge(best_valid_finalist(found), found);
  const double least = found.best(found.scenes).misfit(found.scenes);
  const ReadPoint& winner = found.at(best_valid_finalist(found).reading);
  std::vector<std::vector<Json>> rows;
  for (const Statement& row : the_rows()) {
    const auto verdict = best.rows.find(row.id);
    if (verdict == best.rows.end() || verdict->second != "not reproduced" || is_judged_only(row)) continue;
    const auto closest =
        std::min_element(found.points.begin(), found.points.end(), [&](const ReadPoint& a, const ReadPoint& b) {
          return row_misfit(row, a.said.at(row.scene)) < row_misfit(row, b.said.at(row.scene));
        });
    rows.push_back({row.quantity, wanted_of(row), said_in(closest->said.at(row.scene), row.id),
                    name_of(concerning(closest->reading, row.scene)), closest->misfit(found.scenes),
                    closest->misfit(found.scenes) - least, lost(*closest, winner, found.scenes)});
  }
  report.heading("What is not reached");
  report.table(
      "Rows that the winner does not reproduce: the closest that any reading tried comes, valid or not, with its "
      "misfit "
      "over all sentences and what that is above the least.",
      {"row", "the paper", "closest", "by, of the choices that concern the scene", "its misfit", "above the least",
       "what the winner is near and it is not"},
      rows);
  add_pair(report, found, "first_impact", "second_contact_fy");
}

void add_untorn(Report& report, const ReadingsFound& found) {
  std::vector<std::vector<Json>> rows;
  int unstable = 0, untorn = 0;
  for (std::size_t k = 0; k < found.untorn.size(); ++k) {
    const Untorn run = untorn_runs()[k];
    const Json& gave = found.untorn[k];
    const bool valid = gave.value("valid", false);
    if (run.strength > 1e6) untorn += 1, unstable += valid ? 0 : 1;
    rows.push_back({run.strength > 1e6 ? Json("never tears") : Json(run.strength), std::round(1e7 * run.step) / 1e4,
                    valid ? "valid" : "invalid", Json(gave.contains("failed") ? gave["failed"] : gave["reason"]),
                    gave.value("reached", Json()), gave.value("torn", Json())});
  }
  report.heading("Without deleting the connections");
  report.text(
      "The paper says that without deleting the connections the stability of its first simulation was not adequate. "
      "Links that never tear: " +
      std::to_string(unstable) + " of " + std::to_string(untorn) + " steps end where the laws hold no longer.");
  report.table("Scene 1 with other strengths, watched as furrow run does it.",
               {"strength [N]", "step [ms]", "validity", "why", "reached [mm]", "links torn"}, rows);
}

}  // namespace furrow::validation
