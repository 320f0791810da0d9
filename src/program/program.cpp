#include "program/program.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>
#include <string_view>

#include "output/build_info.h"
#include "program/commands.h"
#include "program/signals.h"
#include "program/usage.h"
#include "run/prepare.h"
#include "scene/packing.h"
#include "scene/read.h"

namespace furrow {
namespace {

int fail(const std::string& message, ExitCode code) {
  std::cerr << message << "\n";
  return code;
}

// A width that is misspelt would be another one than was asked for.
std::string unknown_vectors() {
  const char* named = std::getenv("FURROW_VECTORS");
  if (!named) return {};
  for (const std::string_view known : {"none", "avx2", "avx512"})
    if (named == known) return {};
  return "the environment variable FURROW_VECTORS is \"" + std::string(named) + "\"; it can be none, avx2 or avx512";
}

int parse_and_run(int argc, char** argv, const std::vector<AddCommands>& parts) {
  CLI::App app{"furrow: a reference solver for soil, tool and root in two dimensions"};
  app.require_subcommand(1);
  app.set_version_flag("--version",
                       "furrow " + std::string(build_info().version) + " (" + std::string(build_info().commit) + ")");
  app.name("furrow");
  show_examples(&app, {"furrow run validation/scenes/scenario_1.toml --until 0.4 --out here",
                       "furrow explain validation/scenes/scenario_2.toml", "furrow run --help"});

  std::vector<Command> commands;
  for (const AddCommands add : parts) add(app, commands);
  if (argc < 2) {
    std::cerr << app.help();
    return bad_input;
  }
  if (const std::string fault = unreadable(argc, argv); !fault.empty())
    return fail("furrow: error: " + fault, bad_input);
  if (const std::string fault = unknown_vectors(); !fault.empty()) return fail("furrow: error: " + fault, bad_input);
  if (const std::string fault = misspelt(app, argc, argv); !fault.empty())
    return fail("furrow: error: " + fault, bad_input);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help or version was asked for
    return fail("furrow: error: " + usage_fault(app, error), bad_input);
  }
  if (const std::string fault = without_value(app); !fault.empty()) return fail("furrow: error: " + fault, bad_input);
  for (const Command& command : commands) {
    if (command.named->parsed()) return command.run();
  }
  return bad_input;
}

int code_of(const std::function<int()>& work) {
  const std::string error = "furrow: error: ";
  try {
    return work();
  } catch (const SceneError& fault) {
    return fail(fault.what(), bad_input);
  } catch (const std::invalid_argument& fault) {
    return fail(error + fault.what(), bad_input);
  } catch (const NoRoom& fault) {
    return fail(error + fault.what(), bad_input);
  } catch (const std::bad_alloc&) {
    return fail(error + "not enough memory", io_failed);
  } catch (const Interrupted& request) {
    return fail(std::string("furrow: ") + request.what(), interrupted);
  } catch (const Divergence& fault) {
    return fail(error + fault.what(), diverged);
  } catch (const std::filesystem::filesystem_error& fault) {
    const std::string place = fault.path1().string();
    return fail(error + "cannot use " + (place.empty() ? "a file" : place) + ": " + fault.code().message(), io_failed);
  } catch (const std::exception& fault) {
    return fail(error + fault.what(), io_failed);
  }
}

// What was to be printed and is lost makes any result one of input and output, but an interrupt stays one.
int code_with_output(int code) {
  const int printed = code_of([] { return flush_standard_output(), good; });
  return printed == good || code == interrupted ? code : printed;
}

}  // namespace

int run_program(int argc, char** argv, const std::vector<AddCommands>& parts) {
  watch_signals();
  guard_standard_streams();
  return code_with_output(code_of([&] { return parse_and_run(argc, argv, parts); }));
}

}  // namespace furrow
