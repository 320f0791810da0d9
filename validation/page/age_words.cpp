#include "validation/page/age_words.h"

#include <set>

namespace furrow::validation {

std::string listed(const std::vector<std::string>& all, std::size_t most) {
  std::string list;
  for (std::size_t k = 0; k < std::min(most, all.size()); ++k) list += (k == 0 ? "" : ", ") + all[k];
  return list + (all.size() > most ? " and " + std::to_string(all.size() - most) + " more" : "");
}

std::string why_old(const Age& age) {
  std::string words;
  if (age.old > age.unknown) {
    std::string since;
    if (!age.changed.empty()) since = "these sources changed: " + listed(age.changed, 8);
    if (!age.inputs.empty())
      since += (since.empty() ? "" : "; ") + ("the input of these changed: " + listed(age.inputs, 8));
    words = std::to_string(age.old - age.unknown) + " of them were made before " + since + ".";
  }
  if (age.unknown > 0)
    words += (words.empty() ? "" : " ") + std::to_string(age.unknown) +
             " of them are old: made by an earlier form, which does not say of which sources.";
  return words;
}

std::string words_of(const Numbers& numbers, const Age& age) {
  std::set<std::string> machines;
  for (const Maker& maker : numbers.makers())
    machines.insert(maker.machine.empty() ? "no known machine" : maker.machine);
  const std::string words =
      std::to_string(age.results) + " results, made " + (age.first.empty() ? "some day" : age.first.substr(0, 10)) +
      (age.last.substr(0, 10) != age.first.substr(0, 10) ? " to " + age.last.substr(0, 10) : "") + " by commit " +
      listed(age.commits, 5) + " on " + listed({machines.begin(), machines.end()}, 3) + ". ";
  return words + (age.old == 0 ? "All are of today's solver." : why_old(age));
}

std::string age_chip(const Age& age, std::size_t old_read) {
  if (age.old == 0 && old_read > 0)
    return "<span class=\"chip none\">reads " + std::to_string(old_read) + " older than the solver</span>";
  if (age.old == 0) return "<span class=\"chip good\">✓ today's solver</span>";
  return "<span class=\"chip bad\">" + std::to_string(age.old) + " of " + std::to_string(age.results) +
         " older than the solver</span>";
}

}  // namespace furrow::validation
