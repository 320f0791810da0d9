#include <CLI/CLI.hpp>
#include <cstdio>

#include "output/build_info.h"
#include "output/files.h"
#include "program/commands.h"
#include "scene/read.h"
#include "system/prepare.h"

namespace {

int parse_and_run(int argc, char** argv) {
  CLI::App app{"furrow: a reference solver for soil, tool and root in two dimensions"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "furrow " + std::string(furrow::build_info().version) + " (" +
                                        std::string(furrow::build_info().commit) + ")");
  app.footer("Exit codes: 0 good, 1 a check failed, 2 usage or scene, 3 diverged, 4 input or output, 130 interrupted.");

  furrow::RunOptions options;
  const auto add_overrides = [&options](CLI::App* command) {
    command->add_option("scene", options.scene, "scene file (TOML)")->required();
    command->add_option("--method", options.method, "integration method, see `furrow methods`");
    command->add_option("--dt", options.step, "time step, s")->check(CLI::PositiveNumber);
  };
  auto* run = app.add_subcommand("run", "run a scene and write its files; run.json goes to standard output too");
  add_overrides(run);
  run->add_option("--until", options.until, "end of the run, s")->check(CLI::PositiveNumber);
  run->add_option("--out", options.directory, "directory for the files (default: runs/NAME)");

  std::vector<std::string> scenes;
  auto* check = app.add_subcommand("check", "read scene files and say all that is wrong with them");
  check->add_option("scenes", scenes, "scene files")->required();

  auto* explain =
      app.add_subcommand("explain", "what of a scene is modelled, what is left out, and what follows from its numbers");
  add_overrides(explain);

  auto* methods = app.add_subcommand("methods", "list the integration methods");

  std::string report_directory = "report";
  std::string scene_directory = "validation/scenes";
  bool reuse = false;
  auto* report = app.add_subcommand("report", "run the paper's three scenes and write one page about them");
  report->add_option("--out", report_directory, "directory for the page and the runs")->capture_default_str();
  report->add_option("--scenes", scene_directory, "directory of the scene files")->capture_default_str();
  report->add_flag("--reuse", reuse, "keep runs that are there and finished, make only the page anew");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? furrow::good : furrow::bad_input;
  }
  if (*run) return furrow::run_command(options);
  if (*check) return furrow::check_command(scenes);
  if (*explain) return furrow::explain_command(options);
  if (*methods) return furrow::methods_command();
  return furrow::report_command(report_directory, scene_directory, reuse);
}

}  // namespace

int main(int argc, char** argv) {
  const auto fail = [](const std::string& what, int code) {
    std::fprintf(stderr, "furrow: error: %s\n", what.c_str());
    return code;
  };
  try {
    return parse_and_run(argc, argv);
  } catch (const furrow::SceneError& error) {
    for (const std::string& message : error.messages()) std::fprintf(stderr, "%s\n", message.c_str());
    return furrow::bad_input;
  } catch (const std::invalid_argument& error) {
    return fail(error.what(), furrow::bad_input);
  } catch (const furrow::Interrupted&) {
    return furrow::interrupted;
  } catch (const furrow::Divergence& error) {
    return fail(error.what(), furrow::diverged);
  } catch (const std::exception& error) {
    return fail(error.what(), furrow::io_failed);
  }
}
