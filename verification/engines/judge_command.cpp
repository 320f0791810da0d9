// The commands cases, judge and engine.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string_view>

#include "methods/method.h"
#include "output/files.h"
#include "output/strict_json.h"
#include "program/method_name.h"
#include "program/progress.h"
#include "program/signals.h"
#include "program/usage.h"
#include "report/embedded.h"
#include "report/inputs.h"
#include "scene/interrupt.h"
#include "verification/commands.h"
#include "verification/engines/furrow_engine.h"
#include "verification/engines/judgement_files.h"

namespace furrow::verification {
namespace {

struct CasesOptions {
  std::vector<std::string> patterns;
  bool json = false, protocol = false;
  int request = 0;  // resolution
};

void list_cases(const std::vector<Json>& cases) {
  for (const Json& c : cases) {
    std::string needs;
    for (const std::string need : c["needs"]) needs += (needs.empty() ? "" : " ") + need;
    std::printf("%-34s %s\n%-34s needs %s\n", c["name"].get<std::string>().c_str(),
                c["title"].get<std::string>().c_str(), "", needs.c_str());
  }
}

int cases_command(const CasesOptions& options) {
  if (options.protocol) {
    std::printf("%s", std::string(embedded("verification/engines/PROTOCOL.md")).c_str());
    return good;
  }
  const std::vector<Json> cases = cases_like(options.patterns);
  if (options.request > 0) {
    if (cases.size() != 1)
      throw std::invalid_argument("--request: the pattern fits " + std::to_string(cases.size()) +
                                  " cases; it must fit one");
    std::printf("%s\n", request_of(cases[0], options.request).dump(2).c_str());
  } else if (options.json) {
    std::printf("%s\n", Json(cases).dump(1).c_str());
  } else if (cases.size() == 1) {
    std::printf("%s",
                std::string(embedded("verification/cases/" + cases[0]["name"].get<std::string>() + ".toml")).c_str());
  } else {
    list_cases(cases);
  }
  return good;
}

struct JudgeOptions {
  std::string engine, json, junit;
  std::vector<std::string> patterns;
  double limit = 120;  // s
};

int exit_code_of(const std::vector<Judgement>& all) {
  bool judged = false, well = true;
  for (const Judgement& j : all) {
    judged = judged || j.verdict != CaseVerdict::cannot;
    well = well && j.verdict <= CaseVerdict::cannot;
  }
  if (!judged) std::fprintf(stderr, "furrow: the engine took none of the cases, so nothing is known of it\n");
  return judged && well ? good : check_failed;
}

// Before the engine is asked: a result of an earlier judge may be replaced, nothing else, and there must be a place for it.
void refuse_foreign(const std::string& file, std::string_view begins) {
  if (file.empty()) return;
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder)) throw FileError(file + ": there is no directory " + folder.string());
  if (access(folder.c_str(), W_OK) != 0) throw FileError(file + ": " + folder.string() + " may not be written");
  const std::filesystem::file_status status =
      std::filesystem::symlink_status(file);  // what is replaced is the link itself
  if (!std::filesystem::exists(status)) return;
  std::ifstream stream(file, std::ios::binary);
  std::string there(begins.size(), '\0');
  stream.read(there.data(), static_cast<std::streamsize>(there.size()));
  there.resize(static_cast<std::size_t>(stream.gcount()));
  if (!std::filesystem::is_regular_file(status) || (!there.empty() && there != begins))
    throw FileError(file + " is there and is no result of furrow judge; move it away, or name another file");
}

void write_judgements(const JudgeOptions& options, const std::vector<Judgement>& all, const std::string& partial) {
  if (!options.json.empty()) replace_file(options.json, judgements_as_json(all, partial).dump(1) + "\n");
  if (!options.junit.empty()) replace_file(options.junit, judgements_as_junit(all, partial));
}

void judge_each(const std::vector<Json>& cases, const JudgeOptions& options, std::vector<Judgement>& all) {
  const Engine engine = program_engine(options.engine, options.limit);
  Progress progress;
  for (const Json& c : cases) {
    throw_if_interrupted();
    progress.show(c["name"], "judging", static_cast<double>(all.size()), static_cast<double>(cases.size()));
    all.push_back(judge_case(c, engine));
    all.back().command = options.engine;
    all.back().input = input_of_case(all.back().name);
    std::printf("%s\n", table_row(all.back()).c_str());
    flush_standard_output();
  }
}

int judge_command(const JudgeOptions& options) {
  const auto place = [](const std::string& file) { return std::filesystem::weakly_canonical(file); };
  if (!options.json.empty() && !options.junit.empty() && place(options.json) == place(options.junit))
    throw std::invalid_argument("--json and --junit name one file; the one would replace the other");
  refuse_foreign(options.json, judgements_begin_json);
  refuse_foreign(options.junit, judgements_begin_junit);
  const std::vector<Json> cases = cases_like(options.patterns);
  std::vector<Judgement> all;
  try {
    judge_each(cases, options, all);
  } catch (const Interrupted&) {  // what was judged so far is kept, and marked
    const std::string partial = std::to_string(all.size()) + " of " + std::to_string(cases.size()) + " cases";
    if (!all.empty()) write_judgements(options, all, partial);
    throw;
  }
  std::printf("\n%s\n", count_line(all).c_str());
  write_judgements(options, all, "");
  return exit_code_of(all);
}

int list_methods() {
  for (const MethodInfo& m : method_catalogue()) {
    if (!m.controlled) std::printf("%s\n", m.name.c_str());
  }
  return good;
}

void require_protocol(const Json& request) {
  const auto refuse = [](const std::string& why) {
    throw std::invalid_argument("the request on standard input " + why + "; see furrow cases --protocol");
  };
  if (!request.is_object()) refuse("is no JSON object");
  if (request.value("protocol", Json()) != 1) refuse("is not of protocol 1");
  for (const char* key : {"step", "count"}) {
    const Json value = request.value(key, Json());
    if (!value.is_number() || !(value.get<double>() > 0)) refuse(std::string("has no ") + key + " above 0");
  }
  if (!request.value("case", Json()).is_object()) refuse("has no case");
}

int engine_command(const std::string& method) {
  require_method("--method", method);
  if (make_method(method)->info().controlled)
    throw std::invalid_argument("--method: " + method +
                                " chooses its own step; the judge asks for steps that are given");
  if (isatty(STDIN_FILENO) != 0)
    std::fprintf(stderr, "furrow: waits for a request, JSON on standard input (furrow cases NAME --request STEPS)\n");
  const Json request = json_or_discarded(bounded_text(std::cin, "standard input"));
  if (request.is_discarded())
    throw std::invalid_argument("the request on standard input is not JSON; see furrow cases --protocol");
  require_protocol(request);
  try {
    std::printf("%s\n", furrow_answer(request, method).dump(2).c_str());
  } catch (const Json::exception& fault) {
    throw std::invalid_argument(std::string("the request does not follow the protocol: ") + fault.what());
  }
  return good;
}

}  // namespace

void add_judge_commands(CLI::App& app, std::vector<Command>& all) {
  static CasesOptions cases_options;
  static JudgeOptions judge_options;
  static std::string method = "verlet";
  static bool methods = false;
  auto* cases = app.add_subcommand("cases", "verification cases that any engine can be given: list, print, take away");
  show_examples(cases, {"furrow cases hertz", "furrow cases hertz_pair", "furrow cases hertz_pair --request 100"});
  cases
      ->add_option("patterns", cases_options.patterns,
                   "parts of their names, or needs; one case is printed whole (default: list all)")
      ->type_name("");
  auto* json = cases->add_flag("--json", cases_options.json, "all of them in one JSON list, written out");
  auto* request =
      cases->add_option("--request", cases_options.request, "what an engine gets of a case at so many steps")
          ->type_name("STEPS")
          ->check(whole_number(1, 100000000))
          ->excludes(json);
  cases->add_flag("--protocol", cases_options.protocol, "how an engine is asked and how it answers")
      ->excludes(json)
      ->excludes(request)
      ->excludes("patterns");

  auto* judge = app.add_subcommand("judge", "give the cases to an engine, and judge its answers");
  show_examples(judge, {"furrow judge --engine 'furrow engine --method verlet' --cases spring --json judged.json"});
  judge
      ->add_option("--engine", judge_options.engine,
                   "a command that takes a request on standard input, see furrow cases --protocol")
      ->required()
      ->type_name("CMD");
  judge->add_option("--cases", judge_options.patterns, "parts of names of cases, or needs (default: all)")
      ->type_name("PATTERN");
  judge->add_option("--json", judge_options.json, "all values and verdicts")->type_name("FILE");
  judge
      ->add_option("--junit", judge_options.junit,
                   "verdicts for a build server; a case that the engine cannot do is skipped")
      ->type_name("FILE");
  judge->add_option("--limit", judge_options.limit, "time for one answer (default: 120)")
      ->type_name("SECONDS")
      ->check(moment());

  auto* engine = app.add_subcommand("engine", "furrow as an engine that furrow judge can ask");
  show_examples(engine, {"furrow cases hertz_pair --request 100 | furrow engine --method rk4"});
  engine->add_option("--method", method, "integration method with a fixed step (default: verlet)")->type_name("NAME");

  engine->add_flag("--methods", methods, "list the methods that take a fixed step, and do nothing else");

  all.insert(all.end(), {{cases, [] { return cases_command(cases_options); }},
                         {judge, [] { return judge_command(judge_options); }},
                         {engine, [] { return methods ? list_methods() : engine_command(method); }}});
}

}  // namespace furrow::verification
