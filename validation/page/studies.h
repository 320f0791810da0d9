// The page's parts about studies: what their chapters make of the numbers that `furrow study` left, and how old these are.
#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "validation/page/evidence.h"
#include "validation/page/page.h"

namespace furrow::validation {

struct StudyResult {
  std::string name;
  Json report;               // what its chapter says, see study.h
  std::string age;           // HTML: when, by which commit and machine the numbers were made, and what changed since
  Age numbers;               // of its own numbers
  std::size_t old_read = 0;  // of those that it reads of other studies
  std::set<std::string> old_times{};  // see old_times_of
  std::set<std::string> machines{};   // that its numbers were made on
  std::string made_by{};              // the command that makes them
};

// Those of all studies that can be shown, in the order of the page; what cannot is said by missing_evidence.
std::vector<StudyResult> study_results(const Evidence& evidence);

// "8123 of 8463 numbers of studies are of today's solver; older: responses (12 of 20), ...", and
// the same of faults and judgements; empty if none are shown.
std::string ages_in_words(const Evidence& evidence);

// HTML. The figures go to the page's files. Throws std::runtime_error if gnuplot fails.
std::string chapter_html(const StudyResult& result, const std::string& number, Page& page);  // without its age
std::string study_section(const StudyResult& result, const std::string& number, Page& page);
// The figure that goes with its headline.
std::string first_figure(const StudyResult& result, Page& page);

// A claim that does not hold, or is not shown today.
struct Refuted {
  std::string id, value, aim, text;  // HTML
  bool old = false;
};
std::vector<Refuted> refuted_claims(const StudyResult& result);
std::size_t claims_in(const StudyResult& result);

}  // namespace furrow::validation
