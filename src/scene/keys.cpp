#include "scene/keys.h"

#include <concepts>
#include <initializer_list>
#include <map>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "scene/schema.h"
#include "scene/toml_value.h"

namespace furrow {
namespace {

// The keys that may be left out where another one is given. It is a visitor of schema.h.
struct FollowLister {
  std::map<std::string, std::string>& other;  // by key
  void operator()(const char*, auto&, const Key&) {}
  void required(const char*, auto&, const Key&) {}
  void follows(const char* key, const char* from) { other[key] = from; }
  template <class Enum>
  void choice(const char*, Enum&, std::initializer_list<Choice<Enum>>, std::string_view) {}
};

std::map<std::string, std::string> keys_that_follow() {
  std::map<std::string, std::string> other;
  FollowLister lister{other};
  Lattice stem{.stem = Stem{}};
  describe(lister, stem);
  return other;
}

// Lists the keys of one struct and of those in it. It is a visitor of schema.h.
class KeyLister {
 public:
  KeyLister(std::string table, std::vector<SceneKey>& all) : table_(std::move(table)), all_(all) {}

  void operator()(const char* name, auto& field, const Key& about) { add(name, field, about).required = false; }
  void required(const char* name, auto& field, const Key& about) {
    SceneKey& key = add(name, field, about);
    key.required = true;
    key.default_value.clear();
  }

  void follows(const char*, const char*) {}

  template <class Enum>
  void choice(const char* name, Enum& field, std::initializer_list<Choice<Enum>> choices, std::string_view meaning) {
    SceneKey key{.path = table_ + name, .type = SceneKey::Type::word, .meaning = std::string(meaning)};
    for (const auto& [word, value, what] : choices) {
      key.words.push_back({word, std::string(what)});
      (value == field ? key.default_value : key.example) = in_quotes(word);
    }
    all_.push_back(std::move(key));
  }

 private:
  // What is in a table is listed after it, so the key is found again by its place.
  SceneKey& add(const char* name, auto& field, const Key& about) {
    const std::size_t place = all_.size();
    all_.push_back({.path = table_ + name,
                    .unit = std::string(about.unit),
                    .range = about.range,
                    .meaning = std::string(about.meaning),
                    .example = std::string(about.example)});
    note(place, field);
    return all_[place];
  }

  void note_value(std::size_t place, SceneKey::Type type, const auto& field) {
    all_[place].type = type;
    all_[place].default_value = toml_value(field);
  }
  void note(std::size_t place, bool& field) { note_value(place, SceneKey::Type::boolean, field); }
  void note(std::size_t place, double& field) { note_value(place, SceneKey::Type::number, field); }
  void note(std::size_t place, Vec2& field) { note_value(place, SceneKey::Type::vector, field); }
  void note(std::size_t place, std::string& field) { note_value(place, SceneKey::Type::text, field); }

  template <std::integral Integer>
  void note(std::size_t place, Integer& field) {
    note_value(place, SceneKey::Type::integer, field);
    all_[place].range = integers_of<Integer>(all_[place].range);
  }

  template <class T>
  void note(std::size_t place, std::optional<T>&) {
    T value{};
    note(place, value);
    all_[place].default_value.clear();
  }

  template <class T>
  void note(std::size_t place, std::vector<T>&) {
    T value{};
    note(place, value);
    all_[place].list = true;
    all_[place].default_value = is_value<T> ? "[]" : "";
  }

  template <class Struct>
  requires(std::is_aggregate_v<Struct>) void note(std::size_t place, Struct& field) {
    all_[place].type = SceneKey::Type::table;
    KeyLister inner(all_[place].path + '.', all_);
    describe(inner, field);
  }

  std::string table_;
  std::vector<SceneKey>& all_;
};

std::vector<SceneKey> listed() {
  std::vector<SceneKey> all;
  Scene defaults;
  KeyLister lister("", all);
  describe(lister, defaults);
  const auto following = keys_that_follow();
  for (SceneKey& key : all)
    if (const auto found = following.find(key.name()); found != following.end() && key.table() == "lattice.")
      key.follows = found->second;
  return all;
}

const char* one(SceneKey::Type type) {
  switch (type) {
    case SceneKey::Type::boolean:
      return "true or false";
    case SceneKey::Type::integer:
      return "an integer";
    case SceneKey::Type::number:
      return "a number";
    case SceneKey::Type::text:
      return "a string";
    case SceneKey::Type::word:
      return "a word";
    case SceneKey::Type::vector:
      return "two numbers";
    case SceneKey::Type::table:
      return "a table";
  }
  return "";
}

const char* many(SceneKey::Type type) {
  switch (type) {
    case SceneKey::Type::integer:
      return "a list of integers";
    case SceneKey::Type::number:
      return "a list of numbers";
    case SceneKey::Type::text:
      return "a list of strings";
    case SceneKey::Type::table:
      return "a list of tables";
    default:
      return "a list";
  }
}

}  // namespace

const std::vector<SceneKey>& scene_keys() {
  static const std::vector<SceneKey> all = listed();
  return all;
}

std::vector<SceneKey> scene_keys(const std::string& pattern) {
  std::vector<SceneKey> found;
  std::vector<std::string> names;
  for (const SceneKey& key : scene_keys()) {
    if (key.path.find(pattern) != std::string::npos) found.push_back(key);
    names.push_back(key.path);
    names.push_back(key.name());
  }
  if (found.empty())
    throw std::invalid_argument("no key has " + in_quotes(pattern) + " in its name" + nearest_or_all(pattern, names) +
                                "; see furrow keys");
  return found;
}

std::string example_of(const SceneKey& table) {
  std::string text;
  for (const SceneKey& key : scene_keys())
    if (key.required && key.table() == table.path + '.') text += key.name() + " = " + key.example + '\n';
  return text.empty() ? "" : (table.list ? "[[" + table.path + "]]" : '[' + table.path + ']') + '\n' + text;
}

std::string type_and_range(const SceneKey& key) {
  std::string text = (key.list ? many(key.type) : one(key.type)) + in_brackets(key.unit);
  const bool any_number = key.range.low == -infinity && key.range.high == infinity;
  if (!any_number) text += ", " + interval(key.range, key.name());
  return text;
}

}  // namespace furrow
