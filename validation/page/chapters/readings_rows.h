// The runs that judge a row of the paper, and the rule by which they do.
#pragma once

#include <string>
#include <vector>

#include "validation/studies/reading_search.h"

namespace furrow::validation {

enum class AtStep { papers, finer };

// What a finalist's packings say of a row, each an object that has the row's id. Of scene "all" a number made of those of
// the three scenes; of "untorn" the runs of the literal reading whose links never tear, 1 where furrow run ends one, at
// the paper's step alone. None where the search did not look at the scene.
std::vector<Json> runs_of(const Statement& row, const Finalist& finalist, const ReadingsFound& found, AtStep step);

// Of a row that is yes or no, what it asks of the runs: "packings come to their end".
std::string what_runs_do(const Statement& row);

// "half of the packings in 2 to 10", "the median within a tenth of 238 N", "half of the packings say row 2".
std::string rule_of(const Statement& row);

}  // namespace furrow::validation
