#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>

#include "methods/method.h"
#include "output/build_info.h"
#include "program/commands.h"
#include "program/signals.h"
#include "scene/read.h"
#include "system/prepare.h"

namespace furrow {
namespace {

int fail(const std::string& message, ExitCode code) {
  std::cerr << message << "\n";
  return code;
}

int check_command(const std::vector<std::string>& scenes) {
  int code = good;
  for (const std::string& file : scenes) {
    try {
      make_method(read_scene(file).time.method);
      std::cout << file << ": ok\n";
    } catch (const SceneError& error) {
      code = fail(error.what(), bad_input);
    } catch (const std::exception& error) {  // cannot be read, or names an unknown method; the others are still checked
      code = fail(file + ": error: " + error.what(), bad_input);
    }
  }
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
  app.footer("Exit codes: 0 good, 1 a check failed, 2 usage or scene, 3 diverged, 4 input or output, 130 interrupted.");

  RunOptions options;
  const auto add_overrides = [&options](CLI::App* command) {
    command->add_option("scene", options.scene, "scene file (TOML)")->required();
    command->add_option("--method", options.method, "integration method, see `furrow methods`");
    command->add_option("--dt", options.step, "time step, s")->check(CLI::PositiveNumber);
  };
  auto* run = app.add_subcommand("run", "run a scene and write its files; run.json goes to standard output too");
  add_overrides(run);
  run->add_option("--until", options.until, "end of the run, s")->check(CLI::PositiveNumber);
  const std::map<std::string, Locate> words{{"none", Locate::none}, {"tears", Locate::tears}, {"all", Locate::all}};
  run->add_option("--locate", options.locate, "what steps end at: nothing, tears, or touches and slips too")
      ->transform(CLI::CheckedTransformer(words));
  run->add_option("--threads", options.threads, "threads in one step, for beds of more than 4,096 discs")
      ->check(CLI::Range(1, 64));
  run->add_option("--out", options.directory, "directory for the files (default: runs/NAME)");

  std::vector<std::string> scenes;
  auto* check = app.add_subcommand("check", "read scene files and say all that is wrong with them");
  check->add_option("scenes", scenes, "scene files")->required();

  auto* explain =
      app.add_subcommand("explain", "what of a scene is modelled, what is left out, and what follows from its numbers");
  add_overrides(explain);

  StabilityOptions standing;
  auto* stability = app.add_subcommand("stability", "how long a step each method may take in a scene where it stands");
  stability->add_option("scene", standing.scene, "scene file (TOML)")->required();
  stability->add_option("--method", standing.methods, "methods (default: all that take a fixed step)");
  stability->add_option("--at", standing.at, "when, s of the run (default: the start)")->check(CLI::NonNegativeNumber);

  auto* methods = app.add_subcommand("methods", "list the integration methods");

  ReportOptions reported;
  auto* report = app.add_subcommand("report", "run the paper's three scenes and write one page about them");
  report->add_option("--out", reported.directory, "directory for the page and the runs")->capture_default_str();
  report->add_option("--scenes", reported.scenes, "directory of the scene files")->capture_default_str();
  report->add_flag("--reuse", reported.reuse, "keep runs that are there and finished, make only the page anew");
  report->add_option("--checks", reported.checks, "checks.json of the verification tests, to be shown on the page");
  report->add_option("--faults", reported.faults, "faults.json of the fault study, to be shown on the page");
  report->add_option("--studies", reported.studies, "directory of the studies' results, to be shown on the page");

  StudyOptions studied;
  const auto add_study_options = [&studied](CLI::App* command) {
    command->add_option("--out", studied.directory, "directory for NAME.json")->capture_default_str();
    command->add_flag("--quick", studied.quick, "the short form");
    command->add_option("--jobs", studied.jobs, "runs at a time (default: one a processor)")
        ->check(CLI::PositiveNumber);
    return command;
  };
  auto* study = add_study_options(app.add_subcommand("study", "run a study; without a name: list the studies"));
  study->add_option("name", studied.name, "name of the study");
  auto* ensemble = add_study_options(app.add_subcommand("ensemble", "study ensemble: the scenes over many packings"));
  ensemble->add_flag("--few", studied.few, "run a few packings, compare them with the kept ensemble in --out");
  auto* statements = add_study_options(app.add_subcommand("statements", "study statements: the paper, judged"));

  GoldenRequest asked;
  auto* golden = app.add_subcommand("golden", "run the paper's scenes and compare them to the bit with earlier runs");
  golden->add_option("--goldens", asked.directory, "directory of the golden outputs")->capture_default_str();
  golden->add_flag("--quick", asked.quick, "scene 1 whole, the others for 0.1 s");
  golden->add_flag("--remake", asked.remake, "write those that differ anew");
  golden->add_option("--reason", asked.reason, "why they are made anew");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? good : bad_input;
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
