// `furrow view`: one page that plays a run.
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "output/files.h"
#include "validation/commands.h"
#include "validation/page/film.h"
#include "validation/page/run_record.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  std::string directory, out;  // out: empty: view.html in the directory
};

int view_command(const ViewOptions& options) {
  const fs::path directory = options.directory;
  if (!fs::is_directory(directory))
    throw FileError(options.directory + ": no such directory; furrow run --out makes one");
  const RunRecord run = read_run(directory.filename(), directory);
  const std::string page = view_page(run, directory);
  const fs::path place = options.out.empty() ? directory / "view.html" : fs::path(options.out);
  OutputFile file(place);
  file << page;
  file.finish();
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
  view->add_option("--out", options.out, "the page (default: view.html in the directory)")->type_name("FILE");
  all.push_back({view, [] { return view_command(options); }});
}

}  // namespace furrow::validation
