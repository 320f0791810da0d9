// What the page rests on besides the runs: the checks, the fault study, the studies. Whether they are all there and
// whole.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/study.h"

namespace furrow::validation {

// Where the results are. A path that is empty was not asked for; the page says that it has none.
struct Evidence {
  std::filesystem::path checks;                 // checks.json, written by the verification tests
  std::filesystem::path faults;                 // faults.json, written by the fault study
  std::filesystem::path studies{};              // directory of the numbers of `furrow study`
  std::vector<Study> catalogue{};               // whose chapters make the words
  std::string when{};                           // of the page, UTC
  std::filesystem::path mutants{};              // mutants.json, written by scripts/mutants
  std::filesystem::path judgements{};           // judgements.json, written by scripts/judge
  std::vector<std::filesystem::path> scenes{};  // whose runs the players put beside the three
};

// The studies that a page shows, in the order of its parts.
const std::vector<std::string>& studies_of_the_page();

// What is wrong with a file; empty if it can be shown.
std::string unusable_study(const Evidence& evidence, const std::string& name);
std::string unusable_checks(const std::filesystem::path& file);
std::string unusable_faults(const std::filesystem::path& file);

// A sentence for each file that was asked for and is missing, cut, changed, of a short form or says that something
// failed, with the command that makes it. Empty: the page has all that it was asked for.
std::vector<std::string> missing_evidence(const Evidence& evidence);

// One for each kind of evidence that was not asked for: what the page does not tell, and what makes it.
std::vector<std::string> evidence_not_given(const Evidence& evidence);

}  // namespace furrow::validation
