// The commands of the solver on the command line.
#include <algorithm>
#include <cstdio>

#include "methods/method.h"
#include "program/commands.h"
#include "program/program.h"
#include "program/usage.h"

namespace furrow {
namespace {

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

int export_or_compare(const ExportOptions& options) {
  if (!options.compare.empty()) return compare_command(options);
  if (options.scene.scene.empty() || options.scene.directory.empty())
    throw std::invalid_argument("export needs a scene and --out DIR, or --compare DIR");
  return export_command(options);
}

}  // namespace

void add_solver_commands(CLI::App& app, std::vector<Command>& all) {
  static RunOptions options;
  static std::vector<std::string> scenes;
  static KeysOptions keys_options;
  static ExportOptions exported;
  const auto add_overrides = [](CLI::App* command, RunOptions& to) {
    auto* scene = command->add_option("scene", to.scene, "scene file (TOML)")->type_name("");
    if (&to == &options) scene->required();
    command->add_option("--method", to.method, "integration method, see furrow methods")->type_name("NAME");
    command->add_option("--dt", to.step, "time step; rows are written no oftener")->type_name("SECONDS");
    command->add_option("--set", to.set, "a key of the scene, as in --set disc[0].radius=0.02; see furrow keys")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
  };
  auto* run = app.add_subcommand(
      "run",
      "run a scene and write its files; run.json goes to standard output too, to a terminal its sum in four lines");
  add_overrides(run, options);
  run->add_option("--until", options.until, "end of the run; pictures after it are left out")->type_name("SECONDS");
  run->add_option("--locate", options.locate, "what steps end at: none, tears, or all (touches and slips too)")
      ->type_name("WORD");
  run->add_option("--threads", options.threads, "threads in one step, for beds of more than 4,096 discs")
      ->type_name("NUMBER");
  run->add_option("--solver", options.solver, "kernel, or reference: every pair, one after the other, to the same bits")
      ->type_name("WORD");
  run->add_option("--frames", options.frames,
                  "so many pictures at equal times, instead of those of the scene; for furrow view")
      ->type_name("NUMBER");
  auto* out =
      run->add_option("--out", options.directory, "directory for the files (default: runs/NAME)")->type_name("DIR");
  run->add_option("--resume", options.resume, "go on with the run in this directory, from its last checkpoint")
      ->type_name("DIR")
      ->excludes(out);

  show_examples(run, {"furrow run src/python/stem.toml --frames 4 --out stem",
                      "furrow run validation/scenes/scenario_1.toml --until 0.4 --set 'plate[0].velocity=[0.2, 0.0]'"});
  run->add_flag("--json", options.json, "print run.json on a terminal too, instead of four lines");

  auto* check = app.add_subcommand("check", "read scene files and say all that is wrong with them");
  show_examples(check, {"furrow check src/python/stem.toml validation/scenes/scenario_1.toml"});
  check->add_option("scenes", scenes, "scene files")->required()->type_name("");

  auto* explain =
      app.add_subcommand("explain", "what of a scene is modelled, what is left out, and what follows from its numbers");
  show_examples(explain, {"furrow explain validation/scenes/scenario_1.toml",
                          "furrow explain validation/scenes/scenario_1.toml --method rk4 --dt 5e-4"});
  add_overrides(explain, options);

  auto* deck = app.add_subcommand(
      "export",
      "write a scene as the input of another engine, or compare what that engine made of it with furrow's run");
  show_examples(deck,
                {"furrow export validation/scenes/single_spring.toml --allow lattice.structural.damping --out deck"});
  add_overrides(deck, exported.scene);
  deck->add_option("--until", exported.scene.until, "end of the run")->type_name("SECONDS");
  deck->add_option("--to", exported.to, "the engine: lammps")->type_name("WORD");
  deck->add_option("--out", exported.scene.directory, "directory for the deck")->type_name("DIR");
  deck->add_option("--allow", exported.allow, "a key that may go in by another law; without it such a scene is refused")
      ->type_name("KEY")
      ->expected(1)
      ->take_all();
  auto* compare = deck->add_option("--compare", exported.compare,
                                   "directory of a deck that has run: compare, and write compared.json")
                      ->type_name("DIR");
  for (const char* of_decks : {"scene", "--out", "--to", "--until", "--dt", "--method", "--set", "--allow"})
    compare->excludes(of_decks);
  deck->add_option("--early", exported.early, "how long forces are compared row by row (default: 0.05)")
      ->type_name("SECONDS")
      ->check(moment())
      ->needs("--compare");

  auto* methods = app.add_subcommand("methods", "list the integration methods");
  show_examples(methods, {"furrow methods"});

  auto* keys = app.add_subcommand("keys", "the keys of scene files: meaning, unit, range, default, example");
  show_examples(keys, {"furrow keys contact.friction", "furrow keys --schema >scene.schema.json"});
  keys->add_option("patterns", keys_options.patterns, "parts of their names (default: all keys)")->type_name("");
  auto* json = keys->add_flag("--json", keys_options.json, "as JSON");
  auto* markdown = keys->add_flag("--markdown", keys_options.markdown, "as a page")->excludes(json);
  keys->add_flag("--schema", keys_options.schema, "all of them as JSON Schema, for editors and validators")
      ->excludes(json)
      ->excludes(markdown);

  all.insert(all.end(), {{run, [] { return run_command(options); }},
                         {check, [] { return check_command(scenes); }},
                         {explain, [] { return explain_command(options); }},
                         {deck, [] { return export_or_compare(exported); }},
                         {methods, methods_command},
                         {keys, [] { return keys_command(keys_options); }}});
}

}  // namespace furrow
