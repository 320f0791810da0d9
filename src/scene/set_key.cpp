#include "scene/set_key.h"

#include <algorithm>
#include <charconv>
#include <concepts>
#include <initializer_list>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/keys.h"
#include "scene/schema.h"
#include "scene/toml_value.h"

namespace furrow {
namespace {

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? "" : std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

std::string unquoted(const std::string& text) {
  const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
  return quoted ? text.substr(1, text.size() - 2) : text;
}

// "[a, b]"; nothing if it is no list.
std::optional<std::vector<std::string>> list_of(const std::string& text) {
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return {};
  std::vector<std::string> items;
  std::string_view rest = std::string_view(text).substr(1, text.size() - 2);
  while (!trimmed(rest).empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    items.push_back(trimmed(rest.substr(0, comma)));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return items;
}

// "lattice[0].rows": the key, its index, and what follows.
struct Step {
  explicit Step(const std::string& path)
      : key(path.substr(0, path.find('.'))), rest(path.substr(std::min(key.size() + 1, path.size()))) {
    const std::size_t open = key.find('[');
    if (open == std::string::npos || key.back() != ']') return;
    std::size_t number = 0;
    const char* end = key.data() + key.size() - 1;
    const auto read = std::from_chars(key.data() + open + 1, end, number);
    if (read.ec != std::errc{} || read.ptr != end) return;
    index = number;
    key.resize(open);
  }

  std::string key, rest;
  std::optional<std::size_t> index{};
};

// What a path leads to in a field: a list's item, an optional's content, else the field.
template <class T>
struct Target {
  using type = T;
  static constexpr bool list = false;
};
template <class T>
struct Target<std::optional<T>> : Target<T> {};
template <class T>
struct Target<std::vector<T>> {
  using type = T;
  static constexpr bool list = true;
};

// Finds the key and sets it. It is a visitor of schema.h.
class KeySetter {
 public:
  KeySetter(const std::string& path, const std::string& text) : step_(path), text_(text) {}

  void operator()(const char* key, auto& field, const Key& about) {
    if (!is_it(key)) return;
    if (double* one = component_of(field)) {
      fault_ = set(*one, text_, about.unit);
      return;
    }
    fault_ = misplaced(field);
    if (fault_.empty()) fault_ = set(field, text_, about.unit);
  }
  void required(const char* key, auto& field, const Key& about) { (*this)(key, field, about); }

  void follows(const char* key, const char* other) {
    if (is_it(key)) fault_ = "follows from " + std::string(other) + ": leave it out";
  }

  template <class Enum>
  void choice(const char* key, Enum& field, std::initializer_list<Choice<Enum>> choices, std::string_view) {
    if (!is_it(key)) return;
    fault_ = misplaced(field);
    if (!fault_.empty()) return;
    std::vector<std::string> words;
    for (const auto& [word, value, meaning] : choices) {
      words.emplace_back(word);
      if (word == unquoted(text_)) return static_cast<void>(field = value);
    }
    fault_ = "must be one of " + joined(words) + ", not " + in_quotes(text_) + did_you_mean(text_, words);
  }

  std::string fault() const {
    return found_ ? fault_ : "unknown key " + in_quotes(step_.key) + nearest_or_all(step_.key, known_);
  }

  // Of the first step of a path. What stands in a table is often named without it.
  std::string fault_at_top() const {
    if (found_ || !nearest_name(step_.key, known_).empty()) return fault();
    const std::string name = step_.key.substr(0, step_.key.find('['));
    for (const SceneKey& key : scene_keys())
      if (key.name() == name)
        return "unknown key " + in_quotes(step_.key) + "; did you mean " + in_quotes(key.path) + "?";
    return fault();
  }

 private:
  bool is_it(const char* key) {
    known_.emplace_back(key);
    const bool is = step_.key == key;
    found_ = found_ || is;
    return is;
  }

  // "origin.x": one of the two numbers.
  static double* component_of(auto&) { return nullptr; }
  double* component_of(Vec2& field) const {
    return step_.index ? nullptr : step_.rest == "x" ? &field.x : step_.rest == "y" ? &field.y : nullptr;
  }

  // The path has an index or further keys where there are none.
  template <class T>
  std::string misplaced(const T&) const {
    if (step_.index && !Target<T>::list) return "is no list: leave out the [...]";
    if (is_value<typename Target<T>::type> && !step_.rest.empty())
      return "is a value: it has no key " + in_quotes(step_.rest);
    return {};
  }

  static std::string must_be(const std::string& what, std::string_view unit, const std::string& text) {
    return "must be " + what + in_brackets(unit) + ", not " + in_quotes(text);
  }

  static std::string set(std::string& field, const std::string& text, std::string_view) {
    field = unquoted(text);
    return {};
  }

  static std::string set(bool& field, const std::string& text, std::string_view unit) {
    if (text != "true" && text != "false") return must_be("true or false", unit, text);
    field = text == "true";
    return {};
  }

  template <class Number>
  requires(std::floating_point<Number> || std::integral<Number>) static std::string
      set(Number& field, const std::string& text, std::string_view unit) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || rest != end)
      return must_be(std::integral<Number> ? "an integer" : "a number", unit, text);
    field = number;
    return {};
  }

  static std::string set(Vec2& field, const std::string& text, std::string_view unit) {
    const auto items = list_of(text);
    if (!items || items->size() != 2) return must_be("two numbers, [x, y],", unit, text);
    Vec2 both;
    std::string fault = set(both.x, (*items)[0], unit);
    if (fault.empty()) fault = set(both.y, (*items)[1], unit);
    if (fault.empty()) field = both;
    return fault;
  }

  template <class T>
  std::string set(std::optional<T>& field, const std::string& text, std::string_view unit) const {
    T value = field.value_or(T{});
    std::string fault = set(value, text, unit);
    if (fault.empty()) field = value;
    return fault;
  }

  template <class T>
  std::string set(std::vector<T>& items, const std::string& text, std::string_view unit) const {
    if (step_.index) {
      if (*step_.index < items.size()) return set(items[*step_.index], text, unit);
      return "there is no item " + std::to_string(*step_.index) + ": the scene has " + std::to_string(items.size());
    }
    if constexpr (is_value<T>) {
      const auto texts = list_of(text);
      if (!texts) return must_be("a list, [a, b],", unit, text);
      std::vector<T> values(texts->size());
      for (std::size_t i = 0; i < values.size(); ++i)
        if (std::string fault = set(values[i], (*texts)[i], unit); !fault.empty()) return fault;
      items = std::move(values);
      return {};
    } else {
      return "is a list; say which item, as in " + step_.key + "[0]";
    }
  }

  template <class Struct>
  requires(std::is_aggregate_v<Struct>) std::string set(Struct& field, const std::string& text, std::string_view)
  const {
    KeySetter inner(step_.rest, text);
    describe(inner, field);
    return step_.rest.empty() ? "is a table; set one of its keys: " + joined(inner.known_) : inner.fault();
  }

  Step step_;
  std::string text_, fault_{};
  std::vector<std::string> known_{};
  bool found_ = false;
};

}  // namespace

std::string set_key(Scene& scene, const std::string& path, const std::string& text) {
  KeySetter setter(path, trimmed(text));
  describe(setter, scene);
  return setter.fault_at_top();
}

}  // namespace furrow
