#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <iostream>
#include <new>

#include "methods/method.h"
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

int methods_command() {
  std::size_t widest = 0;
  for (const MethodInfo& m : method_catalogue()) widest = std::max(widest, m.name.size());
  const int width = static_cast<int>(widest);
  std::printf("%-*s  order  f a step  step        what\n", width, "name");
  std::string family = "own";
  for (const MethodInfo& m : method_catalogue()) {
    if (m.family != family) std::printf("\nBoost.Odeint\n");
    family = m.family;
    const std::string evaluations =
        m.evaluations == 0 ? "varies" : std::to_string(m.evaluations) + (m.dense_jacobian ? " + n" : "");
    std::printf("%-*s  %5d  %8s  %-10s  %s%s%s\n", width, m.name.c_str(), m.order, evaluations.c_str(),
                m.controlled ? "controlled" : "fixed", m.title.c_str(),
                m.conservative ? "; no forces that depend on velocity" : "",
                m.dense_jacobian ? "; n numbers of state, at most 200" : "");
  }
  return good;
}

int parse_and_run(int argc, char** argv) {
  CLI::App app{"furrow: a reference solver for soil, tool and root in two dimensions"};
  app.require_subcommand(1);
  app.set_version_flag("--version",
                       "furrow " + std::string(build_info().version) + " (" + std::string(build_info().commit) + ")");
  app.name("furrow");
  app.footer(
      "Examples:\n  furrow run validation/scenes/scenario_1.toml --until 0.4 --out here\n"
      "  furrow explain validation/scenes/scenario_2.toml\n\n"
      "Exit codes: 0 good, 1 a check failed, 2 usage or scene, 3 diverged or invalid, 4 input or output (a scene that\n"
      "cannot be read, too), 130 interrupted. Without a command furrow prints this help and exits with 2.");

  RunOptions options;
  const auto add_overrides = [&options](CLI::App* command) {
    command->add_option("scene", options.scene, "scene file (TOML)")->required()->type_name("");
    command->add_option("--method", options.method, "integration method, see furrow methods")->type_name("NAME");
    command->add_option("--dt", options.step, "time step; rows are written no oftener")->type_name("SECONDS");
  };
  auto* run = app.add_subcommand("run", "run a scene and write its files; run.json goes to standard output too");
  add_overrides(run);
  run->add_option("--until", options.until, "end of the run; pictures after it are left out")->type_name("SECONDS");
  run->add_option("--locate", options.locate, "what steps end at: none, tears, or all (touches and slips too)")
      ->type_name("WORD");
  run->add_option("--threads", options.threads, "threads in one step, for beds of more than 4,096 discs")
      ->type_name("NUMBER");
  run->add_option("--solver", options.solver, "kernel, or reference: every pair, one after the other, to the same bits")
      ->type_name("WORD");
  auto* out =
      run->add_option("--out", options.directory, "directory for the files (default: runs/NAME)")->type_name("DIR");
  run->add_option("--resume", options.resume, "go on with the run in this directory, from its last checkpoint")
      ->type_name("DIR")
      ->excludes(out);

  std::vector<std::string> scenes;
  auto* check = app.add_subcommand("check", "read scene files and say all that is wrong with them");
  check->add_option("scenes", scenes, "scene files")->required()->type_name("");

  auto* explain =
      app.add_subcommand("explain", "what of a scene is modelled, what is left out, and what follows from its numbers");
  add_overrides(explain);

  StabilityOptions standing;
  auto* stability = app.add_subcommand("stability", "how long a step each method may take in a scene where it stands");
  stability->add_option("scene", standing.scene, "scene file (TOML)")->required()->type_name("");
  stability->add_option("--method", standing.methods, "methods (default: all that take a fixed step)")
      ->type_name("NAME");
  stability->add_option("--at", standing.at, "when in the run (default: its start)")
      ->check(moment())
      ->type_name("SECONDS");

  auto* methods = app.add_subcommand("methods", "list the integration methods");

  ReportOptions reported;
  auto* report = app.add_subcommand("report", "run the paper's three scenes and write one page about them");
  report->add_option("--out", reported.directory, "directory for the page and the runs")
      ->capture_default_str()
      ->type_name("DIR");
  report->add_option("--scenes", reported.scenes, "directory of the scene files")
      ->capture_default_str()
      ->type_name("DIR");
  report->add_flag("--reuse", reported.reuse, "keep runs that are there and finished, make only the page anew");
  report->add_option("--checks", reported.checks, "checks.json of the verification tests, to be shown on the page")
      ->type_name("FILE");
  report->add_option("--faults", reported.faults, "faults.json of the fault study, to be shown on the page")
      ->type_name("FILE");
  report->add_option("--studies", reported.studies, "directory of the studies' results, to be shown on the page")
      ->type_name("DIR");

  StudyOptions studied;
  const auto add_study_options = [&studied](CLI::App* command) {
    command->add_option("--out", studied.directory, "directory for NAME.json")->capture_default_str()->type_name("DIR");
    command->add_flag("--quick", studied.quick, "the short form");
    command->add_option("--jobs", studied.jobs, "runs at a time (default: one a processor)")
        ->check(whole_number(1, 1024))
        ->type_name("NUMBER");
    return command;
  };
  auto* study = add_study_options(app.add_subcommand("study", "run a study; without a name: list the studies"));
  study->add_option("name", studied.name, "name of the study")->type_name("");
  auto* ensemble = add_study_options(app.add_subcommand("ensemble", "the scenes over many packings"));
  ensemble->add_flag("--few", studied.few, "run a few packings, compare them with the kept ensemble in --out");
  auto* statements = add_study_options(app.add_subcommand("statements", "the paper's statements, each judged"));

  GoldenRequest asked;
  auto* golden = app.add_subcommand("golden", "run the paper's scenes and compare them to the bit with earlier runs");
  golden->add_option("--goldens", asked.directory, "directory of the golden outputs")
      ->capture_default_str()
      ->type_name("DIR");
  golden->add_flag("--quick", asked.quick, "scene 1 whole, the others for 0.1 s");
  golden->add_flag("--remake", asked.remake, "write those that differ anew");
  golden->add_option("--reason", asked.reason, "why they are made anew")->type_name("TEXT");

  if (argc < 2) {
    std::cerr << app.help();
    return bad_input;
  }
  if (const std::string fault = misspelt(app, argc, argv); !fault.empty())
    return fail("furrow: error: " + fault, bad_input);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help or version was asked for
    return fail("furrow: error: " + usage_fault(app, error), bad_input);
  }
  if (*run) return run_command(options);
  if (*check) return check_command(scenes);
  if (*explain) return explain_command(options);
  if (*stability) return stability_command(standing);
  if (*methods) return methods_command();
  if (*golden) return golden_command(asked);
  for (const CLI::App* named : {ensemble, statements}) {
    if (*named) studied.name = named->get_name();
  }
  if (*study || *ensemble || *statements) return study_command(studied);
  return report_command(reported);
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
}  // namespace furrow

int main(int argc, char** argv) {
  furrow::watch_signals();
  furrow::guard_standard_streams();
  return furrow::code_with_output(furrow::code_of([&] { return furrow::parse_and_run(argc, argv); }));
}
