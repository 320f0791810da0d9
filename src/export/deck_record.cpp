#include "export/deck_record.h"

#include <fstream>
#include <iterator>
#include <string_view>

#include "output/build_info.h"
#include "output/files.h"
#include "output/strict_json.h"
#include "scene/hash.h"
#include "scene/wording.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* file_name = "export.json";
constexpr const char* scene_name = "scene.toml";
constexpr const char* own_hash = "hash";  // of the rest of export.json

std::string hash_of(std::string_view text) { return hexadecimal(Fnv1a().add(text).value()); }

std::string text_of(const fs::path& file) {
  std::error_code unreachable;
  std::ifstream stream(file, std::ios::binary);
  if (!fs::is_regular_file(file, unreachable) || !stream)
    throw FileError(file.string() + ": cannot be read; export the scene again");
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Record {
 public:
  explicit Record(const fs::path& file) : file_(file), json_(json_or_discarded(text_of(file))) {
    if (!json_.is_object()) fail("is not what furrow export writes");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(file_.string() + ": " + what + "; export the scene again");
  }

  std::string text(const Json& table, const std::string& field, const std::string& path) const {
    if (!table.is_object() || !table.contains(field)) fail(in_quotes(path) + " is missing");
    if (!table[field].is_string()) fail(in_quotes(path) + " is not a string");
    return table[field];
  }
  std::string text(const std::string& field) const { return text(json_, field, field); }

  const Json& field(const std::string& name, bool list) const {
    if (!json_.contains(name)) fail(in_quotes(name) + " is missing");
    const Json& found = json_[name];
    if (list && !found.is_array()) fail(in_quotes(name) + " is not a list");
    if (!list && !found.is_object()) fail(in_quotes(name) + " is not a table");
    return found;
  }

  void require_own_hash() const {
    const std::string kept = text(own_hash);
    Json rest = json_;
    rest.erase(own_hash);
    if (kept != hash_of(rest.dump())) fail("is not as furrow export wrote it");
  }

 private:
  const fs::path file_;
  const Json json_;
};

void require_files(const Record& record, const fs::path& directory) {
  const Json& files = record.field("files", false);
  for (const char* needed : {"in.lammps", "data.lammps", scene_name})
    record.text(files, needed, "files." + std::string(needed));
  for (const auto& [name, unused] : files.items()) {
    const std::string kept = record.text(files, name, "files." + name);
    if (hash_of(text_of(directory / name)) != kept)
      throw FileError((directory / name).string() +
                      ": is not as furrow export wrote it; export the scene again, and run the engine again");
  }
  if (record.text("scene_hash") != files[scene_name]) record.fail("\"scene_hash\" is not that of scene.toml");
}

}  // namespace

std::string deck_record(const DeckFiles& files, const std::vector<KeyRow>& deviations) {
  Json json{{"to", "lammps"}, {"furrow", build_info().commit}, {"scene_hash", ""}, {"files", Json::object()}};
  for (const auto& [name, text] : files) json["files"][name] = hash_of(text);
  json["scene_hash"] = json["files"].at(scene_name);
  json["deviations"] = Json::array();
  for (const KeyRow& row : deviations)
    json["deviations"].push_back({{"key", row.key}, {"how", to_string(row.fidelity)}, {"text", row.text}});
  json[own_hash] = hash_of(json.dump());
  return json.dump(1) + "\n";
}

DeckRecord read_deck_record(const fs::path& directory) {
  const Record record(directory / file_name);
  DeckRecord read{.to = record.text("to"),
                  .furrow = record.text("furrow"),
                  .scene_hash = record.text("scene_hash"),
                  .deviations = record.field("deviations", true)};
  for (std::size_t k = 0; k < read.deviations.size(); ++k) {
    for (const char* field : {"key", "how", "text"})
      record.text(read.deviations[k], field, item("deviations", k) + "." + field);
  }
  record.field("files", false);
  record.require_own_hash();
  require_files(record, directory);
  return read;
}

}  // namespace furrow
