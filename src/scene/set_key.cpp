#include "scene/set_key.h"

#include <charconv>
#include <concepts>
#include <initializer_list>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/schema.h"
#include "scene/wording.h"

namespace furrow {
namespace {

// Finds the key and sets it. It is a visitor of schema.h.
class KeySetter {
 public:
  KeySetter(const std::string& path, const std::string& text)
      : key_(path.substr(0, path.find('.'))), rest_(path.substr(std::min(key_.size() + 1, path.size()))), text_(text) {}

  void operator()(const char* key, auto& field, std::string_view unit = "", const Range& = {}) {
    if (key == key_) set(field, unit);
  }
  void required(const char* key, auto& field, std::string_view unit = "", const Range& = {}) {
    (*this)(key, field, unit);
  }

  template <class Enum>
  void choice(const char* key, Enum& field, std::initializer_list<std::pair<const char*, Enum>> choices) {
    if (key != key_) return;
    found_ = true;
    std::vector<std::string> words;
    for (const auto& [word, value] : choices) {
      words.emplace_back(word);
      if (word == text_) return static_cast<void>(field = value);
    }
    fault_ = "must be one of " + joined(words) + ", not " + in_quotes(text_) + did_you_mean(text_, words);
  }

  bool found() const { return found_; }
  const std::string& fault() const { return fault_; }

 private:
  void set(std::string& field, std::string_view) { found_ = true, field = text_; }

  template <class Number>
  requires(std::floating_point<Number> ||
           (std::integral<Number> && !std::same_as<Number, bool>)) void set(Number& field, std::string_view unit) {
    found_ = true;
    Number number{};
    const char* end = text_.data() + text_.size();
    const auto [rest, error] = std::from_chars(text_.data(), end, number);
    if (error == std::errc{} && rest == end)
      field = number;
    else
      fault_ = std::string("must be ") + (std::integral<Number> ? "an integer" : "a number") + in_brackets(unit) +
               ", not " + in_quotes(text_);
  }

  template <class Struct>
  requires(std::is_aggregate_v<Struct>) void set(Struct& field, std::string_view) {
    KeySetter inner(rest_, text_);
    describe(inner, field);
    found_ = inner.found_;
    fault_ = inner.fault_;
  }

  void set(auto&, std::string_view) {}  // lists and the like are no matter of one text

  std::string key_, rest_, text_, fault_{};
  bool found_ = false;
};

}  // namespace

std::string set_key(Scene& scene, const std::string& path, const std::string& text) {
  KeySetter setter(path, text);
  describe(setter, scene);
  if (!setter.found()) throw std::logic_error("no key " + path + " can be set by a text");
  return setter.fault();
}

}  // namespace furrow
