// A scene as the input of another engine, and its output beside furrow's own run.
#include "export/export.h"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "export/compare.h"
#include "output/build_info.h"
#include "output/owned_directory.h"
#include "program/commands.h"
#include "program/progress.h"
#include "scene/read.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

std::string keys_page(const std::vector<KeyRow>& rows, const std::vector<KeyRow>& deviations) {
  std::string text = "# How the keys of the scene went to LAMMPS\n\n";
  const auto table = [&](const std::vector<KeyRow>& all) {
    text += "| key | how | what |\n|---|---|---|\n";
    for (const KeyRow& row : all)
      text += "| `" + row.key + "` | " + to_string(row.fidelity) + " | " + row.text + " |\n";
  };
  text +=
      deviations.empty() ? "Nothing deviates but by the order of the step.\n" : "What deviates, all of it allowed:\n\n";
  if (!deviations.empty()) table(deviations);
  text += "\n## All keys\n\n";
  table(rows);
  return text;
}

std::string export_json(const std::vector<KeyRow>& deviations) {
  nlohmann::ordered_json json{
      {"to", "lammps"}, {"furrow", build_info().commit}, {"deviations", nlohmann::ordered_json::array()}};
  for (const KeyRow& row : deviations)
    json["deviations"].push_back({{"key", row.key}, {"how", to_string(row.fidelity)}, {"text", row.text}});
  return json.dump(1) + "\n";
}

Prepared prepared_with_progress(const ExportOptions& options) {
  Progress progress;
  const Scene scene = requested_scene(options.scene);
  return prepare(
      scene, [&](double t, double) { return progress.show(options.scene.scene, "settling", t, scene.settle->limit); });
}

// What an engine has left of the deck that stood there: it would be compared with the new one.
void remove_old_output(const fs::path& directory) {
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename();
    for (const char* kind : {"force.", "end.", "links.", "torn."}) {
      if (name.starts_with(kind) && name.ends_with(".txt")) old.push_back(entry.path());
    }
    if (name == "compared.json") old.push_back(entry.path());
  }
  for (const fs::path& file : old) fs::remove(file);
}

}  // namespace

int export_command(const ExportOptions& options) {
  if (options.to != "lammps") throw std::invalid_argument("--to: must be lammps, not \"" + options.to + "\"");
  const Prepared prepared = prepared_with_progress(options);
  const std::vector<KeyRow> deviations = lammps_deviations(prepared);
  refuse_deviations(deviations, options.allow);
  const LammpsDeck deck = lammps_deck(prepared);
  const fs::path directory = options.scene.directory;
  OwnedDirectory owned(directory, "export", {"in.lammps", "data.lammps", "scene.toml", "keys.md", "export.json"});
  remove_old_output(directory);
  replace_file(directory / "in.lammps", deck.input);
  replace_file(directory / "data.lammps", deck.data);
  replace_file(directory / "scene.toml", canonical_text(started_scene(prepared)));
  replace_file(directory / "keys.md", keys_page(lammps_keys(prepared), deviations));
  replace_file(directory / "export.json", export_json(deviations));
  owned.conclude("finished");
  for (const KeyRow& row : deviations)
    std::printf("%s: %s: %s\n", to_string(row.fidelity).c_str(), row.key.c_str(), row.text.c_str());
  std::printf("%s: in.lammps, data.lammps; keys.md says how each key went in\n", directory.string().c_str());
  std::printf(
      "run it there by: lmp -in in.lammps   or: mpirun -np 2 lmp -in in.lammps   then: furrow export --compare %s\n",
      directory.string().c_str());
  return good;
}

int compare_command(const ExportOptions& options) {
  std::error_code unreachable;
  if (!fs::is_directory(options.compare, unreachable))
    throw FileError(options.compare + ": no such directory; furrow export --out makes one");
  const Compared compared = compare_with_engine(options.compare, options.early);
  std::printf("%s", compared.text.c_str());
  replace_file(fs::path(options.compare) / "compared.json", compared.json.dump(1) + "\n");
  return compared.good ? good : check_failed;
}

}  // namespace furrow
