// `furrow view`: one page that plays a run.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "output/file_list.h"
#include "output/files.h"
#include "output/owned_directory.h"
#include "program/progress.h"
#include "program/usage.h"
#include "scene/missing_path.h"
#include "validation/commands.h"
#include "validation/page/film.h"
#include "validation/page/run_record.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  std::string directory, out;  // out: empty: view.html in the directory
};

constexpr const char* page_name = "view.html";

void write(OutputFile&& file, const std::string& page) {
  file << page;
  file.finish();
}

// In the run's own directory it is one of its files: it is made again, and goes with the run.
void write_own(const fs::path& directory, const std::string& ended, const std::string& page) {
  OwnedDirectory run(directory, "run", {page_name}, OwnedDirectory::Earlier::kept);
  write(OutputFile::rewriting(directory / page_name), page);
  run.conclude(ended);
}

int view_command(const ViewOptions& options) {
  const fs::path directory = options.directory;
  if (!fs::is_directory(directory))
    throw FileError(options.directory + ": no such directory, furrow run --out makes one" +
                    instead_of(directory, PathKind::directory));
  if (!fs::exists(directory / "run.json"))
    throw FileError((directory / "run.json").string() + ": there is none: the run has not ended, or this is none");
  Progress progress;
  progress.begin(options.directory, "drawing");
  if (const std::string spoilt = spoilt_file(directory); !spoilt.empty())
    throw FileError(options.directory + ": " + spoilt + ": run it again");
  const RunRecord run = read_run(directory.filename(), directory);
  const std::string page = view_page(run, directory);
  const fs::path place = options.out.empty() ? directory / page_name : fs::path(options.out);
  if (options.out.empty())
    write_own(directory, run.fact("ended")->texts.front(), page);
  else
    write(OutputFile::at_once(place), page);
  progress.end();
  std::cout << place.string() << "\n";
  return good;
}

}  // namespace

void add_view_command(CLI::App& app, std::vector<Command>& all) {
  static ViewOptions options;
  auto* view =
      app.add_subcommand("view", "make one page, without other files, that plays a run beside its force curve");
  show_examples(view, {"furrow run src/python/stem.toml --frames 150 --out film", "furrow view film --out film.html"});
  view->add_option("directory", options.directory, "directory of a run, best of one with --frames 150")
      ->required()
      ->type_name("");
  view->add_option("--out", options.out, "the page (default: view.html in the directory)")->type_name("FILE");
  all.push_back({view, [] { return view_command(options); }});
}

}  // namespace furrow::validation
