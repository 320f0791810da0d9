// The paper as a list of sentences, each judged by rows; validation/sentences.toml says how.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/page/run_record.h"
#include "validation/studies/members.h"

namespace furrow::validation {

struct Sentence {
  std::string text, where, against, untested;
  std::vector<std::string> rows;
  bool judged_only = false;  // came after the first search: in no misfit
};

// Throws std::runtime_error that says what is wrong with the TOML text, unknown rows included.
std::vector<Sentence> read_sentences(std::string_view toml, const std::vector<Statement>& rows);

const std::vector<Sentence>& the_sentences();
const std::vector<Statement>& the_rows();  // those of statements.toml, then those of sentences.toml
const Statement& row_named(const std::string& id);

// Whether a row came after the first search. Such a row is in no misfit, and no run measures it: its number is that of
// another row of its scene with the same observable, or is made of other rows' (validation/page/chapters/readings_rows).
bool is_judged_only(const Statement& row);

// The row as it was stated before the first search, by which a misfit is counted; its range may be wider since.
const Statement& as_stated(const Statement& row);

// What a run of a scene says of its rows, by id; see observed().
Json observed_rows(const Scene& made, const std::string& scene);
std::string hash_of_observed_rows(const Scene& made, const std::string& scene);

// 0 to 1: how far a row, as stated, is from what the paper says, see validation/sentences.toml.
double row_misfit(const Statement& row, const Json& said);

// Of the rows that belong to those scenes. What each scene says stands under its name.
double misfit_of(const std::map<std::string, Json>& said, const std::vector<std::string>& scenes);

// The verdict of a row by its packings at the paper's step and at a finer one: that of verdict_of, or "only at this step"
// where the finer step takes it away. Without runs at a finer step: verdict_of.
std::string row_verdict(const Statement& row, const std::vector<Json>& said, const std::vector<Json>& finer);

// The worst of its rows; "not testable" without rows.
std::string rows_verdict(const Sentence& sentence, const std::map<std::string, std::string>& row_verdicts);

// The same; "contradicted by the paper itself" where no number keeps both a row of its own and the one that
// it stands against; "not testable" without rows.
std::string sentence_verdict(const Sentence& sentence, const std::map<std::string, std::string>& row_verdicts);

}  // namespace furrow::validation
