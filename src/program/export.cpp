// A scene as the input of another engine, and its output beside furrow's own run.
#include "export/export.h"

#include <cstdio>
#include <filesystem>
#include <list>
#include <stdexcept>

#include "export/compare.h"
#include "export/deck_record.h"
#include "output/owned_directory.h"
#include "program/commands.h"
#include "program/progress.h"
#include "scene/missing_path.h"
#include "scene/read.h"
#include "scene/utf8.h"
#include "scene/wording.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

constexpr const char* compared_name = "compared.json";

// A whole file under another name, until it is finished.
struct WrittenBeside {
  WrittenBeside(const fs::path& path, const std::string& text) : file(OutputFile::replacing(path)) {
    file << text;
    file.flush();
  }
  OutputFile file;
};

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

Prepared prepared_with_progress(const ExportOptions& options) {
  Progress progress;
  const Scene scene = requested_scene(options.scene);
  progress.begin(options.scene.scene, "placing");
  return prepare(
      scene, [&](double t, double) { return progress.show(options.scene.scene, "settling", t, scene.settle->limit); });
}

// What an engine has left of the deck that stood there: it would be compared with the new one.
std::vector<fs::path> old_output(const fs::path& directory) {
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename();
    if (refine_of(name) == 0 && name != compared_name) continue;
    if (!fs::is_regular_file(entry.symlink_status()))
      throw FileError(entry.path().string() +
                      " is in the way: it is no regular file; move it away, or choose another --out");
    old.push_back(entry.path());
  }
  return old;
}

DeckFiles deck_files(const Prepared& prepared, const std::vector<KeyRow>& deviations) {
  const LammpsDeck deck = lammps_deck(prepared);
  DeckFiles files{{"in.lammps", deck.input},
                  {"data.lammps", deck.data},
                  {"scene.toml", canonical_text(started_scene(prepared))},
                  {"keys.md", keys_page(lammps_keys(prepared), deviations)}};
  files.emplace_back("export.json", deck_record(files, deviations));
  return files;
}

// The new files are all written beside the old ones before one of these goes.
void write_deck(const fs::path& directory, const DeckFiles& files) {
  std::vector<std::string> names;
  for (const auto& [name, text] : files) names.push_back(name);
  OwnedDirectory owned(directory, "export", names, OwnedDirectory::Earlier::kept);
  const std::vector<fs::path> old = old_output(directory);
  std::list<WrittenBeside> written;
  for (const auto& [name, text] : files) written.emplace_back(directory / name, text);
  for (const fs::path& file : old) fs::remove(file);
  for (WrittenBeside& one : written) one.file.finish();
  owned.keep_only(names);
  owned.conclude("finished");
}

}  // namespace

int export_command(const ExportOptions& options) {
  if (options.to != "lammps")
    throw std::invalid_argument("--to: must be lammps, not " + in_quotes(visible(options.to)) +
                                did_you_mean(options.to, {"lammps"}));
  const Prepared prepared = prepared_with_progress(options);
  const std::vector<KeyRow> deviations = lammps_deviations(prepared);
  refuse_deviations(deviations, options.allow);
  for (const std::string& key : needless(options.allow, deviations))
    std::fprintf(stderr, "furrow: note: --allow %s: the scene does not deviate there\n", key.c_str());
  const fs::path directory = options.scene.directory;
  write_deck(directory, deck_files(prepared, deviations));
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
    throw FileError(options.compare + ": no such directory, furrow export --out makes one" +
                    instead_of(options.compare, PathKind::directory));
  if (!(options.early > 0)) throw std::invalid_argument("--early: must be more than 0 s");
  const fs::path result = fs::path(options.compare) / compared_name;
  if (fs::is_regular_file(result, unreachable)) fs::remove(result);  // of an earlier comparison
  Progress progress;
  progress.begin(options.compare, "comparing");
  const Compared compared = compare_with_engine(options.compare, options.early);
  progress.end();
  std::printf("%s", compared.text.c_str());
  replace_file(result, compared.json.dump(1) + "\n");
  return compared.good.value_or(!compared.in_vain) ? good : check_failed;
}

}  // namespace furrow
