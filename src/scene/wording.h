// Words for messages about scenes: numbers, names in quotes, and the known name that a misspelt one is nearest to.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

// The shortest decimal text that reads back as the same double; "inf", "-inf" and "nan" for what is not finite.
inline std::string shortest(double number) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

// So many significant digits, as "%.3g" has them: the caller's locale has no say in it, the C library's neither.
inline std::string rounded(double number, int digits) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, number, std::chars_format::general, digits).ptr};
}

// So many decimals, as "%.3f" has them.
inline std::string fixed(double number, int decimals) {
  char text[400];  // the largest has 309 digits before its point
  return {text, std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, decimals).ptr};
}

// So many decimals before the power of ten, as "%.2e" has them.
inline std::string scientific(double number, int decimals) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, number, std::chars_format::scientific, decimals).ptr};
}

// A sentence with numbers in it: the caller's global locale has no say in how they look.
class Sentence : public std::ostringstream {
 public:
  Sentence() { imbue(std::locale::classic()); }
};

inline std::string in_quotes(std::string_view word) { return '"' + std::string(word) + '"'; }

// "lattice[2]", as paths name it.
inline std::string item(std::string_view list, std::size_t i) {
  return std::string(list) + '[' + std::to_string(i) + ']';
}

inline std::string joined(const std::vector<std::string>& words, const char* between = ", ") {
  std::string list;
  for (const std::string& word : words) list += (&word == &words.front() ? "" : between) + word;
  return list;
}

// Number of letters to insert, delete, replace or swap with their neighbour (optimal string alignment distance).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = above;
    above = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

// Whether two words have the same letters, in whatever order.
inline bool same_letters(std::string a, std::string b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

// The nearest of the known names: of which at most a third of the letters is wrong; else one with the same letters in
// another order; else the shortest that the word, of three letters or more, is a part of. Nothing if there is none.
inline std::string nearest_name(std::string_view word, const std::vector<std::string>& known) {
  std::string nearest, mixed_up, longer_name;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& name : known) {
    // Lengths alone bound the distance from below; without this a key of a million letters takes a million steps a
    // name.
    const std::size_t longer = std::max(name.size(), word.size()), shorter = std::min(name.size(), word.size());
    if (word.size() >= 3 && name.find(word) != std::string::npos &&
        (longer_name.empty() || name.size() < longer_name.size()))
      longer_name = name;
    if (mixed_up.empty() && longer == shorter && same_letters(name, std::string(word))) mixed_up = name;
    if (longer - shorter >= least) continue;
    const std::size_t distance = edit_distance(word, name);
    if (distance < least) least = distance, nearest = name;
  }
  return !nearest.empty() ? nearest : !mixed_up.empty() ? mixed_up : longer_name;
}

// `; did you mean "x"?` with the nearest of the known names, or nothing.
inline std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(word, known);
  return nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?";
}

// The nearest of the known names, or all of them if none is near; of very many the three that are least far.
inline std::string nearest_or_all(std::string_view word, std::vector<std::string> known) {
  constexpr std::size_t many = 30, most_letters = 100;
  std::string nearest = did_you_mean(word, known);
  if (!nearest.empty() || known.empty()) return nearest;
  if (known.size() <= many) return "; known: " + joined(known);
  const std::string begins(word.substr(0, most_letters));
  const auto nearer = [&](const std::string& a, const std::string& b) {
    return edit_distance(begins, a) < edit_distance(begins, b);
  };
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  std::stable_sort(known.begin(), known.end(), nearer);
  known.resize(3);
  return "; the least far of those that there are: " + joined(known);
}

}  // namespace furrow
