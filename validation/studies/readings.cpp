#include "validation/studies/readings.h"

#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>

#include "report/embedded.h"
#include "scene/wording.h"

namespace furrow::validation {
namespace {

constexpr const char* file = "validation/readings.toml";

std::string text_in(const toml::table& table, const char* key) {
  const auto text = table[key].value<std::string>();
  if (!text || text->empty()) throw std::runtime_error(std::string(file) + ": " + key + " is missing");
  return *text;
}

template <class Number>
Number number_in(const toml::table& table, const char* key) {
  const auto number = table[key].value<Number>();
  if (!number) throw std::runtime_error(std::string(file) + ": search." + key + " is missing");
  return *number;
}

const toml::array& list_in(const toml::table& table, const char* key) {
  const toml::array* list = table[key].as_array();
  if (!list || list->empty()) throw std::runtime_error(std::string(file) + ": there is no " + key);
  return *list;
}

Alternative alternative_of(const toml::table& table) {
  Alternative a{text_in(table, "id"), text_in(table, "name"), text_in(table, "reason"), {}};
  for (const toml::node& set : list_in(table, "set")) a.set.push_back(set.value_or(std::string()));
  a.drawn = table["drawn"].value_or(true);
  a.since = table["since"].value_or(1);
  return a;
}

// Of a table with an alternative's id for each choice that is not literal.
Interpretation named_in(const toml::table& table, const std::vector<Choice>& choices) {
  Interpretation reading(choices.size(), 0);
  for (const auto& entry : table) {
    const std::string id(entry.first.str()), which = entry.second.value_or(std::string());
    const auto choice = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.id == id; });
    if (choice == choices.end()) throw std::runtime_error(std::string(file) + ": no choice " + id);
    const auto& all = choice->alternatives;
    const auto one = std::find_if(all.begin(), all.end(), [&](const Alternative& a) { return a.id == which; });
    if (one == all.end()) throw std::runtime_error(std::string(file) + ": no alternative " + which + " of " + id);
    reading[static_cast<std::size_t>(choice - choices.begin())] = static_cast<int>(one - all.begin());
  }
  return reading;
}

std::string listed(const Interpretation& reading, std::string Alternative::*what) {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < reading.size(); ++k) {
    const Choice& choice = the_readings().choices[k];
    if (reading[k] != 0)
      all.push_back(choice.id + " " + choice.alternatives[static_cast<std::size_t>(reading[k])].*what);
  }
  return joined(all);
}

}  // namespace

const Readings& the_readings() {
  static const Readings all = [] {
    Readings readings;
    const toml::table root = toml::parse(embedded(file));
    const toml::table& search = *root["search"].as_table();
    readings.random = number_in<int>(search, "random");
    readings.exchanges = number_in<int>(search, "exchanges");
    readings.valid_exchanges = number_in<int>(search, "valid_exchanges");
    readings.finalists = number_in<int>(search, "finalists");
    readings.packings = number_in<int>(search, "packings");
    readings.fine_step = number_in<double>(search, "fine_step");
    readings.seed = number_in<std::uint64_t>(search, "seed");
    for (const toml::node& node : list_in(root, "choice")) {
      const toml::table& table = *node.as_table();
      readings.choices.push_back({text_in(table, "id"), text_in(table, "open"), {}});
      for (const toml::node& one : list_in(table, "alternative"))
        readings.choices.back().alternatives.push_back(alternative_of(*one.as_table()));
    }
    for (const toml::node& node : list_in(root, "point")) {
      const toml::table& table = *node.as_table();
      readings.named.emplace_back(text_in(table, "by"), named_in(*table["reading"].as_table(), readings.choices));
    }
    for (const toml::node& node : list_in(root, "unsearched"))
      readings.unsearched.emplace_back(text_in(*node.as_table(), "open"), text_in(*node.as_table(), "why"));
    return readings;
  }();
  return all;
}

std::string ids_of(const Interpretation& reading) { return listed(reading, &Alternative::id); }
std::string words_of(const Interpretation& reading) { return listed(reading, &Alternative::name); }

}  // namespace furrow::validation
