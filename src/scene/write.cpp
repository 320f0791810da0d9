// A scene as canonical TOML, and its hash.
#include <concepts>
#include <cstdio>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include "scene/read.h"
#include "scene/schema.h"
#include "scene/wording.h"

namespace furrow {
namespace {

std::string text_of(bool value) { return value ? "true" : "false"; }
std::string text_of(std::integral auto value) { return std::to_string(value); }
std::string text_of(double value) {
  const std::string digits = shortest(value);
  return digits.find_first_of(".ein") == std::string::npos ? digits + ".0" : digits;  // e, inf, nan: a float already
}

std::string text_of(const Vec2& v) { return '[' + text_of(v.x) + ", " + text_of(v.y) + ']'; }

// Letters beyond ASCII stand as they are; controls, which no sound scene holds, by their number.
std::string text_of(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    char code[8];
    const auto byte = static_cast<unsigned char>(c);
    std::snprintf(code, sizeof code, "\\u%04X", byte);
    text += byte < 0x20 || byte == 0x7F ? code : c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  }
  return text + '"';
}

template <class T>
constexpr bool is_value = std::is_same_v<T, Vec2> || !std::is_aggregate_v<T>;

// Writes one struct of the scene as one table. It is a visitor of schema.h.
class TableWriter {
 public:
  explicit TableWriter(std::string path) : path_(std::move(path)) {}
  std::string text() const { return values_ + tables_; }

  void operator()(const char* key, auto& field, const auto&...) { write(key, field); }
  void required(const char* key, auto& field, const auto&...) { write(key, field); }

  template <class Enum>
  void choice(const char* key, Enum& field, std::initializer_list<std::pair<const char*, Enum>> choices) {
    for (const auto& [word, value] : choices)
      if (value == field) add(key, in_quotes(word));
  }

 private:
  void add(const std::string& key, const std::string& value) { values_ += key + " = " + value + '\n'; }
  template <class T>
  void write(const std::string& key, T& field, const char* open = "[", const char* close = "]") {
    if constexpr (is_value<T>) {
      add(key, text_of(field));
    } else {
      TableWriter writer(path_ + key + '.');
      describe(writer, field);
      tables_ += '\n' + (open + path_) + key + close + '\n' + writer.text();
    }
  }

  template <class T>
  void write(const std::string& key, std::optional<T>& field) {
    if (field) write(key, *field);
  }

  template <class T>
  void write(const std::string& key, std::vector<T>& items) {
    std::string list;
    for (T& item : items)
      if constexpr (is_value<T>)
        list += (list.empty() ? "" : ", ") + text_of(item);
      else
        write(key, item, "[[", "]]");
    if (is_value<T>) add(key, '[' + list + ']');
  }

  std::string path_, values_, tables_;
};

}  // namespace

std::string canonical_text(const Scene& scene) {
  Scene copy = scene;  // the schema describes what may be written to
  TableWriter writer("");
  describe(writer, copy);
  return writer.text();
}

std::uint64_t scene_hash(const Scene& scene) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a, 64 bits: offset basis and prime
  for (const char c : canonical_text(scene)) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

}  // namespace furrow
