// The keys of scene files as JSON, and as JSON Schema, by which editors complete a scene and mark what is wrong in it.
#include <cmath>
#include <nlohmann/json.hpp>

#include "program/commands.h"
#include "scene/wording.h"

namespace furrow {
namespace {

using Json = nlohmann::ordered_json;

// Values of scenes are written in TOML as in JSON, but for infinity, which JSON does not have.
Json value_of(const std::string& toml) { return toml.empty() || toml == "inf" ? Json() : Json::parse(toml); }

const char* name_of(SceneKey::Type type) {
  switch (type) {
    case SceneKey::Type::boolean:
      return "boolean";
    case SceneKey::Type::integer:
      return "integer";
    case SceneKey::Type::number:
      return "number";
    case SceneKey::Type::vector:
      return "vector";
    case SceneKey::Type::table:
      return "table";
    default:
      return "string";
  }
}

Json limit(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json in_json(const SceneKey& key) {
  Json json{{"key", key.path},
            {"type", name_of(key.type)},
            {"list", key.list},
            {"required", key.required},
            {"unit", key.unit},
            {"minimum", limit(key.range.low)},
            {"minimum_excluded", key.range.low_open},
            {"maximum", limit(key.range.high)},
            {"maximum_excluded", key.range.high_open},
            {"default", key.default_value},
            {"example", key.example},
            {"meaning", key.meaning},
            {"follows", key.follows},
            {"words", Json::object()}};
  for (const auto& [word, meaning] : key.words) json["words"][word] = meaning;
  return json;
}

void add_limits(Json& json, const Range& range) {
  if (std::isfinite(range.low)) json[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
  if (std::isfinite(range.high)) json[range.high_open ? "exclusiveMaximum" : "maximum"] = range.high;
}

Json table_schema(const std::string& table);

Json item_schema(const SceneKey& key) {
  if (key.type == SceneKey::Type::table) return table_schema(key.path + '.');
  Json json{{"type", key.type == SceneKey::Type::vector ? "number" : name_of(key.type)}};
  add_limits(json, key.range);
  for (const auto& word : key.words) json["enum"].push_back(word.word);
  if (key.type != SceneKey::Type::vector) return json;
  return {{"type", "array"}, {"items", json}, {"minItems", 2}, {"maxItems", 2}};
}

Json key_schema(const SceneKey& key) {
  Json json{{"description", key.meaning + in_brackets(key.unit)}};
  for (const auto& [word, meaning] : key.words)
    json["description"] = json["description"].get<std::string>() + " \"" + word + "\": " + meaning + '.';
  if (const Json value = value_of(key.default_value); !value.is_null()) json["default"] = value;
  if (!key.example.empty()) json["examples"].push_back(value_of(key.example));
  const Json item = item_schema(key);
  json.update(key.list ? Json{{"type", "array"}, {"items", item}} : item);
  return json;
}

// Where the key that these follow from is given none of them is; else those that are required are.
void add_choice(Json& json, const std::vector<SceneKey>& unless) {
  json["if"]["required"] = {unless.front().follows};
  for (const SceneKey& key : unless) {
    json["then"]["properties"][key.name()] = false;
    if (key.required) json["else"]["required"].push_back(key.name());
  }
}

// `table` as "lattice.node.", or empty for the scene.
Json table_schema(const std::string& table) {
  Json json{{"type", "object"}, {"additionalProperties", false}};
  std::vector<SceneKey> unless;
  for (const SceneKey& key : scene_keys()) {
    if (key.table() != table) continue;
    json["properties"][key.name()] = key_schema(key);
    if (!key.follows.empty())
      unless.push_back(key);
    else if (key.required)
      json["required"].push_back(key.name());
  }
  if (!unless.empty()) add_choice(json, unless);
  return json;
}

}  // namespace

std::string keys_as_json(const std::vector<SceneKey>& keys) {
  Json json = Json::array();
  for (const SceneKey& key : keys) json.push_back(in_json(key));
  return json.dump(2) + '\n';
}

std::string scene_schema() {
  Json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", "A scene of furrow"},
            {"description", "Made by furrow keys --schema. What keys say to each other is judged by furrow check."}};
  json.update(table_schema(""));
  return json.dump(2) + '\n';
}

}  // namespace furrow
