// Prints the keys of scene files.
#include <iostream>
#include <set>

#include "program/commands.h"

namespace furrow {
namespace {

std::vector<SceneKey> wanted_keys(const std::vector<std::string>& patterns) {
  if (patterns.empty()) return scene_keys();
  std::set<std::string> paths;
  for (const std::string& pattern : patterns)
    for (const SceneKey& key : scene_keys(pattern)) paths.insert(key.path);
  std::vector<SceneKey> wanted;
  for (const SceneKey& key : scene_keys())
    if (paths.contains(key.path)) wanted.push_back(key);
  return wanted;
}

std::string in_words(const SceneKey& key) {
  std::string text = key.path + "\n    " + type_and_range(key);
  if (key.required) text += "; required";
  if (!key.follows.empty()) text += "; not with " + key.follows;
  if (!key.default_value.empty()) text += "; default " + key.default_value;
  text += "\n    " + key.meaning + '\n';
  for (const auto& [word, meaning] : key.words) text += "      \"" + word + "\": " + meaning + '\n';
  if (!key.example.empty()) text += "    " + key.name() + " = " + key.example + '\n';
  return text;
}

}  // namespace

int keys_command(const KeysOptions& options) {
  const std::vector<SceneKey> keys = wanted_keys(options.patterns);
  if (options.schema) return std::cout << scene_schema(), good;
  if (options.json) return std::cout << keys_as_json(keys), good;
  if (options.markdown) return std::cout << keys_as_page(keys), good;
  for (const SceneKey& key : keys) std::cout << (&key == &keys.front() ? "" : "\n") << in_words(key);
  return good;
}

}  // namespace furrow
