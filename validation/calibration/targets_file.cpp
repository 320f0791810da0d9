#include "validation/calibration/targets_file.h"

#include <toml++/toml.h>

#include <stdexcept>

#include "output/files.h"
#include "output/strict_json.h"
#include "scene/toml_text.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json json_of(const toml::node& node) {
  Json json;
  node.visit([&](const auto& value) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (toml::is_table<T>) {
      json = Json::object();
      for (const auto& [key, item] : value) json[std::string(key.str())] = json_of(item);
    } else if constexpr (toml::is_array<T>) {
      json = Json::array();
      for (const auto& item : value) json.push_back(json_of(item));
    } else if constexpr (toml::is_string<T> || toml::is_integer<T> || toml::is_floating_point<T> ||
                         toml::is_boolean<T>) {
      json = value.get();
    } else {
      json = "a date";
    }
  });
  return json;
}

std::string at_line(const fs::path& file, std::uint32_t line) { return file.string() + ":" + std::to_string(line); }

// toml++ bounds how deep values are nested, but not how many parts a key has: 200,000 of them overflow the stack.
void refuse_endless_keys(const fs::path& file, const std::string& text) {
  safe_text(text, [&](TextPosition at, const char* fault) {
    throw std::invalid_argument(at_line(file, at.first) + ": " + fault);
  });
}

Json toml_in(const fs::path& file, const std::string& text) {
  refuse_endless_keys(file, text);
  try {
    return json_of(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(at_line(file, error.source().begin.line) + ": " + std::string(error.description()));
  }
}

}  // namespace

std::string text_in(const fs::path& file) { return bounded_text(file); }

Json json_in(const fs::path& file) {
  const std::string text = text_in(file);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || text[begin] != '{') return toml_in(file, text);  // with which no TOML begins
  try {
    return strict_json(text);
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument(file.string() + ": " + fault.what());
  }
}

}  // namespace furrow::validation
