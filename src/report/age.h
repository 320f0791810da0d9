// How old kept results are: made with today's sources and inputs, or what has changed since.
#pragma once

#include <functional>
#include <set>

#include "report/numbers.h"

namespace furrow {

// How old the results are, against the sources and the inputs of today.
struct Age {
  std::size_t results = 0, old = 0, timed = 0;
  std::size_t unknown = 0;           // of the old ones: of an earlier form, that does not say of which sources
  std::set<std::string> old_times;   // keys of those that are old and timed
  std::vector<std::string> changed;  // files, since the oldest results were made
  std::vector<std::string> inputs;   // keys of results whose input is another one today
  std::string first, last;           // when the oldest and the newest results were made
  std::vector<std::string> commits;  // of the makers of what is kept, oldest first
};

// What decides results today.
struct Today {
  std::function<const Sources&(const Result&)> sources;
  std::map<std::string, std::string> inputs{};  // by key, of the results that have one
};
Age age_of(const Numbers& numbers, const Today& today);
Age age_of(const Numbers& numbers, const Sources& today);

}  // namespace furrow
