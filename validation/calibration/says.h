// What an observable can say of a run: a number, words, or either.
#pragma once

#include <string>
#include <vector>

namespace furrow::validation {

struct Says {
  bool number = true;
  std::vector<std::string> words{};  // all of them, but for a place
  bool place = false;                // two nodes of a lattice, the ends of a link
  bool window = false;               // it looks at a window of displacement, not always at the whole run
};

Says says_of(const std::string& observable);

// What keeps an observable from saying these words, with those that it can say; empty if nothing does.
std::string fault_of_words(const std::string& observable, const std::string& words);

}  // namespace furrow::validation
