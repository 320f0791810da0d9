#include "validation/calibration/says.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "scene/wording.h"

namespace furrow::validation {
namespace {

constexpr const char* example_of_place = "row 1, column 1 (fixed) to row 2, column 1";

const std::map<std::string, Says>& those_with_words() {
  const auto either = [](const char* words) { return Says{.words = {words}}; };
  const Says if_ever = either("not by the end"), split = either("no split"), second = either("no second contact");
  static const std::map<std::string, Says> all{
      {"first_tear", if_ever},
      {"first_structural_tear", if_ever},
      {"first_structural_tear_place", {.number = false, .words = {"none torn"}, .place = true}},
      {"fixed_links_torn", if_ever},
      {"plate_meets_lattice", if_ever},
      {"split", if_ever},
      {"free_flight_begins", if_ever},
      {"free_flight_ends", if_ever},
      {"split_after_fy", if_ever},
      {"largest_before_split", if_ever},
      {"first_tear_row", if_ever},
      {"pieces", split},
      {"smallest_force_after_split", split},
      {"largest_force_after_split", split},
      {"second_contact_fx", second},
      {"second_contact_fy", second},
      {"finished", {.words = {"comes to its end", "does not come to its end"}}}};
  return all;
}

bool is_place(const std::string& words) {
  static const std::regex place(
      R"(row [1-9][0-9]*, column [1-9][0-9]*( \(fixed\))? to row [1-9][0-9]*, column [1-9][0-9]*( \(fixed\))?)");
  return std::regex_match(words, place);
}

}  // namespace

Says says_of(const std::string& observable) {
  static const std::set<std::string> windowed{"largest_force", "largest_fx",   "largest_fy",  "mean_force",
                                              "mean_fx",       "mean_fy",      "force_ratio", "largest_force_at",
                                              "links_torn",    "proportional", "mean_rise"};
  const auto found = those_with_words().find(observable);
  Says says = found == those_with_words().end() ? Says{} : found->second;
  says.window = windowed.contains(observable);
  return says;
}

std::string fault_of_words(const std::string& observable, const std::string& words) {
  const Says says = says_of(observable);
  if (says.words.empty())
    return observable + " says a number, no words: leave out relation = \"says\", and give a number and a tolerance";
  if (std::find(says.words.begin(), says.words.end(), words) != says.words.end()) return {};
  if (says.place && is_place(words)) return {};
  std::vector<std::string> known;
  for (const std::string& some : says.words) known.push_back(in_quotes(some));
  if (says.place) known.push_back("a place such as " + in_quotes(example_of_place));
  return "the words of " + observable + " are " + joined(known, " or ") + ", not " + in_quotes(words) +
         did_you_mean(words, says.words);
}

}  // namespace furrow::validation
