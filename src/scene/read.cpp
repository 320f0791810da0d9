// The strict reader of scene files. schema.h says what a scene may hold; TableReader walks it beside the parsed TOML.
#include "scene/read.h"

#ifndef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 0  // the distribution's shared library: built with NDEBUG, so that no input trips an assertion
#endif
#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <concepts>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <system_error>
#include <type_traits>
#include <utility>

#include "scene/missing_path.h"
#include "scene/schema.h"
#include "scene/toml_text.h"
#include "scene/utf8.h"
#include "scene/wording.h"

namespace furrow {
namespace {
constexpr std::size_t most_bytes_of_a_file = std::size_t{1} << 28;  // three million discs take less
}

// What the reader of a file writes to, beside the scene.
class FileReader {
 public:
  FileReader(SceneFile& file, std::string_view text)
      : file_(file),
        safe_(safe_text(text, [&](TextPosition at, const char* message) { file.add(at.first, at.second, message); })) {
    file.throw_if_wrong();
  }

  // The value of this path was not taken.
  void unread(toml::source_position at, const std::string& path, const std::string& message) {
    file_.unread_.add(path);
    file_.add(at ? at.line : 1, at ? at.column : 1,
              path + (path.empty() ? "" : ": ") + message);  // an empty file has none
  }

  // A key that nobody knows, and the one that it may stand for.
  void unknown(toml::source_position at, const std::string& path, const std::string& message,
               const std::string& meant) {
    unread(at, path, message);
    if (!meant.empty()) file_.unread_.add(meant);
  }

  bool whole(const toml::node& node, std::string& text) const {
    const toml::source_position at = node.source().begin;
    return restore(safe_, {at.line, at.column}, text);
  }

  toml::table parsed() {
    try {
      return toml::parse(safe_.text);
    } catch (const toml::parse_error& error) {
      const std::string what(error.description());
      const bool again = what.find("cannot redefine existing table") != std::string::npos;
      unread(error.source().begin, "", "not TOML: " + what + (again ? "; tables of a list are headed [[...]]" : ""));
      file_.throw_if_wrong();
      throw;
    }
  }

 private:
  SceneFile& file_;
  SafeText safe_;
};

namespace {

std::string standing(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array_of_tables()) return "a list of tables";
  if (node.is_array()) return "an array of " + std::to_string(node.as_array()->size());
  if (node.is_string()) return "a string";
  if (node.is_integer()) return "an integer";
  if (node.is_floating_point()) return "a float";
  return node.is_boolean() ? "a boolean" : "a date or time";
}

// The path as a header names it: lattice[0].node[2] is lattice.node.
std::string header_of(std::string path) {
  for (std::size_t open; (open = path.find('[')) != std::string::npos;) path.erase(open, path.find(']') - open + 1);
  return path;
}

// A value in the file and what the schema says of it.
struct Entry {
  const toml::node& node;
  std::string path;
  std::string_view unit;
  Range range;
};

// Reads one table into one struct of the scene. It is the visitor that schema.h describes.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string path, FileReader& file)
      : table_(table), path_(std::move(path)), file_(file) {}

  void operator()(const char* key, auto& field, const Key& about) {
    if (const toml::node* node = find(key)) read({*node, path_of(key), about.unit, about.range}, field);
  }

  void required(const char* key, auto& field, const Key& about) {
    (*this)(key, field, about);
    if (table_.contains(key)) return;
    file_.unread(table_.source().begin, path_of(key), "missing, but required" + in_brackets(about.unit));
  }

  void follows(const char* key, const char* other) {
    if (const toml::node* node = find(key))
      file_.unread(node->source().begin, path_of(key), "follows from " + std::string(other) + ": leave it out");
  }

  template <class Enum>
  void choice(const char* key, Enum& field, std::initializer_list<Choice<Enum>> choices, std::string_view) {
    const toml::node* node = find(key);
    if (!node) return;
    auto word = node->value_exact<std::string>();
    if (word) file_.whole(*node, *word);
    std::vector<std::string> words;
    for (const auto& [name, value, meaning] : choices) {
      if (word == name) return static_cast<void>(field = value);
      words.emplace_back(name);
    }
    const std::string got = word ? in_quotes(*word) + did_you_mean(*word, words) : standing(*node);
    file_.unread(node->source().begin, path_of(key), "must be one of " + joined(words) + ", not " + got);
  }

  void refuse_unknown_keys() {
    for (const auto& [key, node] : table_) {
      if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
      const std::string meant = nearest_name(key, known_);
      file_.unknown(key.source().begin, path_of(key), "unknown key" + nearest_or_all(key, known_),
                    meant.empty() ? "" : path_of(meant));
    }
  }

 private:
  const toml::node* find(const char* key) { return known_.emplace_back(key), table_.get(key); }
  std::string path_of(std::string_view key) const { return path_ + (path_.empty() ? "" : ".") + std::string(key); }

  void fault(const Entry& entry, const std::string& message) {
    file_.unread(entry.node.source().begin, entry.path, message);
  }

  void wrong_type(const Entry& e, const std::string& expected) {
    fault(e, "must be " + expected + in_brackets(e.unit) + ", not " + standing(e.node));
  }

  bool accepted(const Range& range, const Entry& e, double number) {
    if (!within(range, number)) fault(e, outside(range, e.path, e.unit, number));
    return within(range, number);
  }

  void read(const Entry& e, bool& field) {
    if (!e.node.is_boolean()) return wrong_type(e, "true or false");
    field = *e.node.value_exact<bool>();
  }

  void read(const Entry& e, std::string& field) {
    if (!e.node.is_string()) return wrong_type(e, "a string");
    std::string text = *e.node.value_exact<std::string>();
    const bool whole = file_.whole(e.node, text);
    const std::string wrong = whole ? text_fault(text) : "must hold no control characters";
    if (wrong.empty())
      field = text;
    else
      fault(e, wrong);
  }

  void read(const Entry& e, double& field) {
    if (!e.node.is_number()) return wrong_type(e, "a number");
    const auto integer = e.node.value_exact<std::int64_t>();
    const double number = integer ? static_cast<double>(*integer) : *e.node.value_exact<double>();
    if (accepted(e.range, e, number)) field = number;
  }

  template <std::integral Integer>
  void read(const Entry& e, Integer& field) {
    if (!e.node.is_integer()) return wrong_type(e, "an integer");
    const std::int64_t number = *e.node.value_exact<std::int64_t>();
    if (accepted(integers_of<Integer>(e.range), e, static_cast<double>(number))) field = static_cast<Integer>(number);
  }

  void read(const Entry& e, Vec2& field) {
    const toml::array* array = e.node.as_array();
    if (!array || array->size() != 2) return wrong_type(e, "an array of two numbers");
    read({(*array)[0], e.path + "[0]", e.unit, e.range}, field.x);
    read({(*array)[1], e.path + "[1]", e.unit, e.range}, field.y);
  }

  template <class T>
  void read(const Entry& e, std::optional<T>& field) {
    read(e, field.emplace());
  }

  template <class T>
  void read(const Entry& e, std::vector<T>& field) {
    const toml::array* array = e.node.as_array();
    const bool tables = std::is_aggregate_v<T>;
    if (!array) return wrong_type(e, tables ? "a list of tables, [[" + header_of(e.path) + "]]" : "an array");
    field.resize(array->size());
    for (std::size_t i = 0; i < field.size(); ++i) read({(*array)[i], item(e.path, i), e.unit, e.range}, field[i]);
  }

  template <class Struct>
  void read(const Entry& e, Struct& field) {
    const toml::table* table = e.node.as_table();
    if (!table) return wrong_type(e, "one table, [" + header_of(e.path) + "]");
    TableReader reader(*table, e.path, file_);
    describe(reader, field);
    reader.refuse_unknown_keys();
  }

  const toml::table& table_;
  std::string path_;
  FileReader& file_;
  std::vector<std::string> known_;
};

// Where the value of a path stands, or else what holds it.
toml::source_position position_of(std::string path, const toml::table& root) {
  for (std::size_t end; !path.empty(); path.resize(end == std::string::npos ? 0 : end)) {
    const auto view = toml::at_path(root, path);
    if (view && view.node()->source().begin) return view.node()->source().begin;
    end = path.find_last_of(".[");
  }
  return {1, 1};
}

}  // namespace

SceneFile SceneFile::parse(std::string_view text, const std::string& name) {
  SceneFile file;
  file.name_ = name;
  FileReader all(file, text);
  const auto root = std::make_shared<toml::table>(all.parsed());
  TableReader reader(*root, "", all);
  describe(reader, file.scene);
  reader.refuse_unknown_keys();
  file.place_ = [root](const std::string& path) {
    const toml::source_position at = position_of(path, *root);
    return std::pair(at.line, at.column);
  };
  return file;
}

SceneFile SceneFile::read(const std::filesystem::path& file) {
  const std::string cannot = "cannot read scene " + in_quotes(file.string()) + ": ";
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw std::runtime_error(cannot + "it is a directory");
  std::ifstream stream(file, std::ios::binary);
  if (const int error = errno; !stream) {
    const std::string why = cannot + std::generic_category().message(error);
    throw std::runtime_error(error == ENOENT || error == ENOTDIR ? why + instead_of(file, PathKind::file) : why);
  }
  std::string text;
  for (std::string part(1 << 20, '\0'); stream && text.size() <= most_bytes_of_a_file;) {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part, 0, static_cast<std::size_t>(stream.gcount()));
  }
  if (text.size() > most_bytes_of_a_file)
    throw std::runtime_error(cannot + "it has more than " + std::to_string(most_bytes_of_a_file) + " bytes");
  if (stream.bad()) throw std::runtime_error(cannot + "input error");
  return parse(text, file.string());
}

}  // namespace furrow
