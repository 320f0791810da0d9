// The keys of scene files as a page in Markdown: a section for each table of a scene.
#include <algorithm>
#include <utility>

#include "program/commands.h"

namespace furrow {
namespace {

// A vertical line would end the cell, and what a star or a low line begins is no emphasis here.
std::string cell(const std::string& text) {
  std::string shown;
  for (const char c : text) shown += c == '|' || c == '*' || c == '_' ? std::string{'\\', c} : std::string{c};
  return shown;
}

std::string code(const std::string& text) { return text.empty() ? "" : '`' + text + '`'; }

std::string meaning_of(const SceneKey& key) {
  std::string text = cell(key.meaning);
  for (const auto& [word, meaning] : key.words) text += "<br>" + code('"' + word + '"') + ": " + cell(meaning);
  return text;
}

std::string row(const SceneKey& key) {
  std::string without = key.required ? "required" : code(key.default_value);
  if (!key.follows.empty()) without += (without.empty() ? "not with " : "; not with ") + code(key.follows);
  return "| " + code(key.name()) + " | " + meaning_of(key) + " | " + cell(type_and_range(key)) + " | " + without +
         " | " + code(key.example) + " |\n";
}

// Of a key the path of the table that it is in, of a table its own.
std::string section_of(const SceneKey& key) {
  const std::string table = key.table();
  return key.type == SceneKey::Type::table ? key.path : table.substr(0, table.empty() ? 0 : table.size() - 1);
}

std::string begin_section(const std::string& path) {
  const std::string head = "| key | what it means | what it may be | default | example |\n|---|---|---|---|---|\n";
  const auto& keys = scene_keys();
  const auto table = std::find_if(keys.begin(), keys.end(), [&](const SceneKey& key) { return key.path == path; });
  if (table == keys.end()) return "\n## At the top\n\n" + head;
  const std::string example = example_of(*table);
  return "\n## " + code(table->list ? "[[" + path + "]]" : '[' + path + ']') + "\n\n" + table->meaning +
         (example.empty() ? "" : "\n\n```toml\n" + example + "```") + "\n\n" + head;
}

}  // namespace

std::string keys_as_page(const std::vector<SceneKey>& keys) {
  std::string text =
      "# The keys of a scene file\n\nMade by `furrow keys --markdown`; `furrow keys PATTERN` prints those with PATTERN "
      "in their names. A table in `[[...]]` may be\ngiven many times. A key without a default does nothing where it "
      "is left out, or what its meaning says.\n";
  std::vector<std::pair<std::string, std::string>> sections;  // path and text: a table may stand amid another's keys
  for (const SceneKey& key : keys) {
    const std::string path = section_of(key);
    auto found = std::find_if(sections.begin(), sections.end(), [&](const auto& s) { return s.first == path; });
    if (found == sections.end()) found = sections.insert(found, {path, begin_section(path)});
    if (key.type != SceneKey::Type::table) found->second += row(key);
  }
  for (const auto& section : sections) text += section.second;
  return text;
}

}  // namespace furrow
