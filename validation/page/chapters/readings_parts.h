// What the chapter on the readings computes from the runs of a search.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/studies/reading_search.h"

namespace furrow::validation {

struct Judgement {
  std::map<std::string, std::string> rows;  // verdict by id
  std::vector<std::string> sentences;       // verdict of each, in the order of the_sentences()
  std::vector<std::string> by_rows;         // the same by its rows alone, whatever the paper says elsewhere
  double misfit = 0, finer_misfit = 0;      // mean over packings
  int older_reproduced = 0;                 // of the rows of statements.toml
};

Judgement judge(const Finalist& finalist, const ReadingsFound& found);

// The least of the larger of its misfits at the two steps: of all finalists, and of those of which `furrow run` ends no
// more runs than of the literal reading.
const Finalist& best_finalist(const ReadingsFound& found);
const Finalist& best_valid_finalist(const ReadingsFound& found);
int watched_runs(const ReadingsFound& found);  // of each finalist

// Whether the scene files say the same as that reading, titles, allowances and outputs aside; `in`: their directory in
// validation/scenes, "" or "best_reading/".
bool is_of_the_scene_files(const Interpretation& reading, const std::vector<std::string>& scenes,
                           const std::string& in = "");

std::string name_of(const Interpretation& reading);
// By what it differs in from the winner, if that is said in fewer words.
std::string name_beside(const Interpretation& reading, const Interpretation& winner);

const std::vector<std::string>& counted_verdicts();
int count_of(const std::vector<std::string>& verdicts, const std::string& verdict);
int testable();  // sentences with rows

// Rows of those scenes whose misfit is below one half: a number within a tenth, a limit that is nearly kept.
int rows_near(const ReadPoint& point, const std::vector<std::string>& scenes);

// What the search cost, and which of its points failed; what two scenes alone choose, by several packings.
void add_budget(Report& report, const ReadingsFound& found, const Numbers& numbers);
void add_fitted(Report& report, const ReadingsFound& found);

// Sections of the chapter: every sentence, what is not reached, scene 1 without tears.
void add_sentences(Report& report, const ReadingsFound& found);
void add_trade_offs(Report& report, const ReadingsFound& found);
void add_untorn(Report& report, const ReadingsFound& found);

std::string wanted_of(const Statement& row);
std::string said_in(const Json& said, const std::string& id);
std::string said_of(const Finalist& finalist, const ReadingsFound& found, const std::string& id);  // median, or words

}  // namespace furrow::validation
