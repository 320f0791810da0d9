// A scene as canonical TOML, and its hash.
#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "scene/hash.h"
#include "scene/read.h"
#include "scene/schema.h"
#include "scene/toml_value.h"

namespace furrow {
namespace {

// Options that are off as a rule: their keys are written where they are on, so that the text of a scene, and its hash by
// which kept results know it, stay what they are when an option comes that it does not use.
constexpr std::pair<std::string_view, std::string_view> options_off[] = {
    {"law", "\"hertz_mindlin\""}, {"slip_damping", "true"}, {"after_slip", "\"elastic\""},
    {"rolling", "\"smoothed\""},  {"ramp", "0.0"},          {"angles", "false"},
    {"fixed_x", "false"},         {"fixed_y", "false"}};

// Writes one struct of the scene as one table. It is a visitor of schema.h.
class TableWriter {
 public:
  explicit TableWriter(std::string path) : path_(std::move(path)) {}
  std::string text() const { return values_ + tables_; }

  void operator()(const char* key, auto& field, const Key&) { write(key, field); }
  void required(const char* key, auto& field, const Key&) { write(key, field); }

  void follows(const char*, const char*) {}

  template <class Enum>
  void choice(const char* key, Enum& field, std::initializer_list<Choice<Enum>> choices, std::string_view) {
    for (const auto& [word, value, meaning] : choices)
      if (value == field) add(key, in_quotes(word));
  }

 private:
  void add(const std::string& key, const std::string& value) {
    if (std::find(std::begin(options_off), std::end(options_off),
                  std::pair<std::string_view, std::string_view>(key, value)) == std::end(options_off))
      values_ += key + " = " + value + '\n';
  }
  template <class T>
  void write(const std::string& key, T& field, const char* open = "[", const char* close = "]") {
    if constexpr (is_value<T>) {
      add(key, toml_value(field));
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
        list += (list.empty() ? "" : ", ") + toml_value(item);
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

std::uint64_t scene_hash(const Scene& scene) { return Fnv1a().add(canonical_text(scene)).value(); }

}  // namespace furrow
