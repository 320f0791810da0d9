// The strict reader of scene files. schema.h says what a scene may hold; TableReader walks it beside the parsed TOML.
#include "scene/read.h"

#ifndef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 0  // the distribution's shared library: built with NDEBUG, so that no input trips an assertion
#endif
#include <toml++/toml.h>

#include <cerrno>
#include <concepts>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <map>
#include <system_error>
#include <type_traits>
#include <utility>

#include "scene/schema.h"
#include "scene/wording.h"

namespace furrow {
namespace {

// All faults of one file, told in the order of its lines.
class Faults {
 public:
  explicit Faults(std::string file) : file_(std::move(file)) {}

  void add(toml::source_position at, const std::string& path, const std::string& message) {
    std::string text = path + (path.empty() ? "" : ": ") + message;
    for (char& c : text) c = printable(c) ? c : '?';                          // keys in quotes may hold anything
    faults_.emplace(at ? at : toml::source_position{1, 1}, std::move(text));  // an empty file has no places
  }

  void throw_if_any() const {
    std::vector<std::string> messages;
    for (const auto& [at, text] : faults_)
      messages.push_back(file_ + ':' + std::to_string(at.line) + ':' + std::to_string(at.column) + ": error: " + text);
    if (!messages.empty()) throw SceneError(std::move(messages));
  }

 private:
  std::string file_;
  std::multimap<toml::source_position, std::string> faults_;
};

// The text as toml++ 3.3 can bear it: nothing but ASCII (it mishandles some other characters), so they are faults
// outside comments and '?' in them; and no key of very many parts, since it deletes nested tables by recursion.
std::string guarded(std::string_view text, Faults& faults) {
  constexpr int most_dots = 16;                                 // in one key; a scene needs two
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  std::string safe(text);
  std::string_view quote;  // what ends the string that i is in; empty outside strings
  bool comment = false, told = false;
  int dots = 0;
  toml::source_index line = 1;
  for (std::size_t i = 0, start = 0; i < safe.size(); ++i) {
    const char c = safe[i];
    const auto fault = [&](const char* message) {  // one a line
      const auto column = static_cast<toml::source_index>(i - start + 1);
      if (!std::exchange(told, true)) faults.add({line, column}, "", message);
    };
    if (static_cast<unsigned char>(c) >= 0x80) {
      if (!comment) fault("only ASCII is accepted outside comments");
      safe[i] = '?';
    } else if (c == '\n') {
      ++line, start = i + 1, dots = 0, comment = told = false;
      if (quote.size() == 1) quote = {};
    } else if (comment) {
      continue;
    } else if (!quote.empty()) {
      const std::string_view rest = text.substr(i);
      if (rest.starts_with(quote)) {
        i += quote.size() - 1;
        while (quote.size() == 3 && i + 1 < text.size() && text[i + 1] == c) ++i;  // of """"" two belong to the string
        quote = {};
      } else if (rest.starts_with("\\\\") || rest.starts_with("\\\"")) {
        ++i;
      }
    } else if (c == '"' || c == '\'') {
      const std::string_view triple = c == '"' ? "\"\"\"" : "'''";
      quote = text.substr(i).starts_with(triple) ? triple : triple.substr(0, 1);
      i += quote.size() - 1;
    } else if (c == '=' || c == ',') {
      dots = 0;
    } else if (c == '.' && ++dots > most_dots) {
      fault("a key of too many parts");
    }
    comment = comment || (c == '#' && quote.empty());
  }
  faults.throw_if_any();
  return safe;
}

toml::table parsed(const std::string& text, Faults& faults) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const std::string what(error.description());
    const bool again = what.find("cannot redefine existing table") != std::string::npos;
    faults.add(error.source().begin, "", "not TOML: " + what + (again ? "; tables of a list are headed [[...]]" : ""));
    faults.throw_if_any();
    throw;
  }
}

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

std::string in_brackets(std::string_view unit) {
  return unit.empty() || unit == "-" ? "" : " [" + std::string(unit) + "]";
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
  TableReader(const toml::table& table, std::string path, Faults& faults)
      : table_(table), path_(std::move(path)), faults_(faults) {}

  void operator()(const char* key, auto& field, std::string_view unit = "", const Range& range = {}) {
    if (const toml::node* node = find(key)) read({*node, path_of(key), unit, range}, field);
  }

  void required(const char* key, auto& field, std::string_view unit = "", const Range& range = {}) {
    (*this)(key, field, unit, range);
    if (table_.contains(key)) return;
    faults_.add(table_.source().begin, path_of(key), "missing, but required" + in_brackets(unit));
  }

  template <class Enum>
  void choice(const char* key, Enum& field, std::initializer_list<std::pair<const char*, Enum>> choices) {
    const toml::node* node = find(key);
    if (!node) return;
    const auto word = node->value_exact<std::string>();
    std::vector<std::string> words;
    for (const auto& [name, value] : choices) {
      if (word == name) return static_cast<void>(field = value);
      words.emplace_back(name);
    }
    const std::string got = word ? in_quotes(*word) + did_you_mean(*word, words) : standing(*node);
    faults_.add(node->source().begin, path_of(key), "must be one of " + joined(words) + ", not " + got);
  }

  void refuse_unknown_keys() {
    for (const auto& [key, node] : table_)
      if (std::find(known_.begin(), known_.end(), key.str()) == known_.end())
        faults_.add(key.source().begin, path_of(key), "unknown key" + nearest_or_all(key, known_));
  }

 private:
  const toml::node* find(const char* key) { return known_.emplace_back(key), table_.get(key); }
  std::string path_of(std::string_view key) const { return path_ + (path_.empty() ? "" : ".") + std::string(key); }

  void fault(const Entry& entry, const std::string& message) {
    faults_.add(entry.node.source().begin, entry.path, message);
  }

  void wrong_type(const Entry& e, const std::string& expected) {
    fault(e, "must be " + expected + in_brackets(e.unit) + ", not " + standing(e.node));
  }

  bool within(const Range& range, const Entry& e, double number) {
    const auto& [low, high, low_open, high_open] = range;
    if ((low_open ? number > low : number >= low) && (high_open ? number < high : number <= high)) return true;
    const std::string key = e.path.substr(e.path.rfind('.') + 1);
    const std::string interval = shortest(low) + (low_open ? " < " : " <= ") + key + (high_open ? " < " : " <= ");
    fault(e, shortest(number) + " is outside " + interval + shortest(high) + in_brackets(e.unit));
    return false;
  }

  void read(const Entry& e, bool& field) {
    if (!e.node.is_boolean()) return wrong_type(e, "true or false");
    field = *e.node.value_exact<bool>();
  }

  void read(const Entry& e, std::string& field) {
    if (!e.node.is_string()) return wrong_type(e, "a string");
    field = *e.node.value_exact<std::string>();
    if (!std::all_of(field.begin(), field.end(), printable)) fault(e, "must hold printable ASCII characters only");
  }

  void read(const Entry& e, double& field) {
    if (!e.node.is_number()) return wrong_type(e, "a number");
    const auto integer = e.node.value_exact<std::int64_t>();
    const double number = integer ? static_cast<double>(*integer) : *e.node.value_exact<double>();
    if (within(e.range, e, number)) field = number;
  }

  template <std::integral Integer>
  void read(const Entry& e, Integer& field) {
    if (!e.node.is_integer()) return wrong_type(e, "an integer");
    const std::int64_t number = *e.node.value_exact<std::int64_t>();
    constexpr auto largest = static_cast<double>(std::numeric_limits<Integer>::max());
    Range range = e.range;
    if (range.high > largest) range.high = largest, range.high_open = false;
    if (within(range, e, static_cast<double>(number))) field = static_cast<Integer>(number);
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
    TableReader reader(*table, e.path, faults_);
    describe(reader, field);
    reader.refuse_unknown_keys();
  }

  const toml::table& table_;
  std::string path_;
  Faults& faults_;
  std::vector<std::string> known_;
};

// Where the value of a path stands, or else what holds it.
toml::source_position position_of(std::string path, const toml::table& root) {
  for (std::size_t end; !path.empty(); path.resize(end == std::string::npos ? 0 : end)) {
    if (const auto view = toml::at_path(root, path)) return view.node()->source().begin;
    end = path.find_last_of(".[");
  }
  return {1, 1};
}

}  // namespace

SceneError::SceneError(std::vector<std::string> messages)
    : std::runtime_error(joined(messages, "\n")), messages_(std::move(messages)) {}

Scene parse_scene(std::string_view text, const std::string& name) {
  Faults faults(name);
  const toml::table root = parsed(guarded(text, faults), faults);
  Scene scene;
  TableReader reader(root, "", faults);
  describe(reader, scene);
  reader.refuse_unknown_keys();
  faults.throw_if_any();
  for (const auto& [path, message] : problems_of(scene)) faults.add(position_of(path, root), path, message);
  faults.throw_if_any();
  return scene;
}

Scene read_scene(const std::filesystem::path& file) {
  const std::string cannot = "cannot read scene " + in_quotes(file.string()) + ": ";
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw std::runtime_error(cannot + "it is a directory");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(cannot + std::generic_category().message(errno));
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  if (stream.bad()) throw std::runtime_error(cannot + "input error");
  return parse_scene(text, file.string());
}

}  // namespace furrow
