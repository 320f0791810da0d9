// `furrow view`: one page that plays a run.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "output/files.h"
#include "output/owned_directory.h"
#include "program/usage.h"
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

bool finite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

// The file with a number that no run writes; empty if there is none.
std::string spoilt_file(const RunRecord& run) {
  const ForceCurve& force = run.force;
  for (const auto* of : {&force.mm, &force.fx, &force.fy, &force.f})
    if (!finite(*of)) return "plate_force.csv";
  for (std::size_t k = 0; k < run.frames.size(); ++k)
    for (const char* column : {"x [m]", "y [m]", "radius [m]"})
      if (!finite(run.frames[k].discs.numbers(column))) return "picture " + std::to_string(k);
  return {};
}

// Before the JSON library says it in its own words. A file that is not there is said by read_run.
void refuse_no_run(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) return;
  const bool empty = stream.peek() == std::ifstream::traits_type::eof();
  if (empty || !nlohmann::json::accept(stream))
    throw FileError(file.string() + (empty ? ": is empty" : ": is no whole JSON") + ": it is not what a run wrote");
}

int view_command(const ViewOptions& options) {
  const fs::path directory = options.directory;
  if (!fs::is_directory(directory))
    throw FileError(options.directory + ": no such directory; furrow run --out makes one");
  refuse_no_run(directory / "run.json");
  const RunRecord run = read_run(directory.filename(), directory);
  if (const std::string why = run.finished() ? broken_off(run) : ""; !why.empty())
    throw FileError(options.directory + ": the run finished, but " + why + ": its files are not whole");
  if (const std::string file = spoilt_file(run); !file.empty())
    throw FileError(options.directory + ": " + file + " has a number that is not finite");
  const std::string page = view_page(run, directory);
  const fs::path place = options.out.empty() ? directory / page_name : fs::path(options.out);
  if (options.out.empty())
    write_own(directory, run.fact("ended")->texts.front(), page);
  else
    write(OutputFile::at_once(place), page);
  std::cout << place.string() << "\n";
  return good;
}

}  // namespace

void add_view_command(CLI::App& app, std::vector<Command>& all) {
  static ViewOptions options;
  auto* view =
      app.add_subcommand("view", "make one page, without other files, that plays a run beside its force curve");
  view->add_option("directory", options.directory, "directory of a run, best of one with --frames 150")
      ->required()
      ->type_name("");
  view->add_option("--out", options.out, "the page (default: view.html in the directory)")
      ->type_name("FILE")
      ->check(word());
  all.push_back({view, [] { return view_command(options); }});
}

}  // namespace furrow::validation
