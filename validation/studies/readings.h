// The readings of the paper: every choice that it leaves open, with its alternatives (validation/readings.toml).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace furrow::validation {

struct Alternative {
  std::string id, name, reason;
  std::vector<std::string> set;  // "KEY=VALUE", "SCENE:KEY=VALUE"
  bool drawn = true;             // false: costs too much to be drawn at random
  int since = 1;                 // the first search that knows it
};

struct Choice {
  std::string id, open;
  std::vector<Alternative> alternatives;  // the first is the literal one
  int since() const { return alternatives.size() > 1 ? alternatives[1].since : 1; }
};

// An alternative of each choice, by its place.
using Interpretation = std::vector<int>;

struct Readings {
  std::vector<Choice> choices;
  std::vector<std::pair<std::string, std::string>> unsearched;  // what, why
  std::vector<std::pair<std::string, Interpretation>> named;    // points that others have found: by whom, which
  int random = 0, exchanges = 0, valid_exchanges = 0, finalists = 0, packings = 0;
  double fine_step = 0;  // s
  std::uint64_t seed = 1;
};
const Readings& the_readings();

std::string ids_of(const Interpretation& reading);    // what is not literal: "damping alpha_20, box 0.54_m"
std::string words_of(const Interpretation& reading);  // the same in words: "damping alpha = 20, box 0.54 m"

}  // namespace furrow::validation
