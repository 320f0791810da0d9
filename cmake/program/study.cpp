
#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "output/build_info.h"
#include "output/files.h"
#include "program/progress.h"
#include "program/usage.h"
#include "program_with_all.h"
#include "scene/utf8.h"
#include "scene/wording.h"
#include "study_status.h"
#include "validation/page/chapters/chapters.h"
#include "validation/studies/few_members.h"
#include "validation/studies/golden.h"

namespace furrow {
namespace {

struct StudyOptions {
  std::string name;  // empty: list the studies
  std::string directory = "studies";
  bool quick = false;
  unsigned jobs = 0;    // 0: as many as there are processors
  bool few = false;     // of the ensemble: a few packings, compared with the kept result in `directory`
  bool anew = false;    // nothing that is kept is taken
  bool status = false;  // how old the kept numbers are
  bool check = false;   // a sample of the kept numbers made again
  std::string made_by;  // what would be made now: by what
  bool words = false;   // what the chapter makes of the kept numbers
};

struct GoldenRequest {
  std::string directory = "reference_data/golden", reason;
  bool quick = false, remake = false;
};

unsigned processors() { return std::max(1U, std::thread::hardware_concurrency()); }

const Study& study_named(const std::string& name) {
  std::vector<std::string> known;
  for (const Study& study : validation::catalogue()) {
    if (study.name == name) return study;
    known.push_back(study.name);
  }
  throw std::invalid_argument("no study is named " + in_quotes(visible(name)) + nearest_or_all(name, known) +
                              "; see furrow study");
}

std::vector<const Study*> studies_asked_for(const StudyOptions& options) {
  std::vector<const Study*> all;
  for (const Study& study : validation::catalogue()) {
    if (options.name.empty()) all.push_back(&study);
  }
  if (all.empty()) all.push_back(&study_named(options.name));
  return all;
}

std::string cell_text(const Json& cell) {
  if (cell.is_string()) return cell;
  return cell.is_number() ? rounded(cell.get<double>(), 3) : "-";
}

std::string row_text(const Json& row) {
  std::string text = "|";
  for (const Json& cell : row) text += " " + cell_text(cell) + " |";
  return text;
}

void print_part(const Json& part) {
  const std::string kind = part.at("kind");
  if (kind == "heading") std::printf("\n## %s\n", part.at("text").get<std::string>().c_str());
  if (kind == "text") std::printf("\n%s\n", part.at("text").get<std::string>().c_str());
  if (kind == "figure" || kind == "table") std::printf("\n%s\n", part.at("caption").get<std::string>().c_str());
  if (kind != "table") return;
  std::printf("\n%s\n%s\n", row_text(part.at("head")).c_str(),
              row_text(std::vector<std::string>(part.at("head").size(), "---")).c_str());
  for (const Json& row : part.at("rows")) std::printf("%s\n", row_text(row).c_str());
}

Json chapter_of(const Study& study, const Shelf& shelf, const StudyOptions& options) {
  try {
    return study.chapter(shelf).json();
  } catch (const Json::exception& error) {
    throw FileError(options.directory + ": " + no_chapter(study, error.what()));
  }
}

// The chapter in Markdown, without its figures; runs nothing.
int words_command(const StudyOptions& options) {
  const Shelf shelf(options.directory);
  for (const Study* study : studies_asked_for(options)) {
    const Json chapter = chapter_of(*study, shelf, options);
    const std::set<std::string> old_times = old_times_of(*study, shelf, validation::catalogue());
    std::printf("# %s\n\n%s\n\n", chapter.at("title").get<std::string>().c_str(),
                chapter.at("question").get<std::string>().c_str());
    for (const Json& claim : chapter.at("claims")) {
      const std::string value = claim.at("value"), aim = claim.at("aim"), text = claim.at("text");
      const char* mark = !claim.at("holds").get<bool>()   ? "Does not hold: "
                         : !holds_today(claim, old_times) ? "By times older than the solver: "
                                                          : "";
      std::printf("- %s%s%s%s%s\n", value.c_str(), aim.empty() ? "" : (" (aim: " + aim + ")").c_str(),
                  value.empty() ? "" : ": ", mark, text.c_str());
    }
    for (const Json& part : chapter.at("parts")) print_part(part);
  }
  return good;
}

// The draw is another one with each commit.
int check_command(const StudyOptions& options) {
  constexpr double most_cpu = 4;  // s a study
  int status = good;
  Progress progress;
  for (const Study* study : studies_asked_for(options)) {
    progress.begin(study->name, "checking");
    const Checked checked =
        check_study(*study, options.directory, std::hash<std::string_view>{}(build_info().commit), most_cpu);
    progress.end();
    std::printf("%-16s %d numbers made again, %zu do not come out\n", study->name.c_str(), checked.compared,
                checked.wrong.size());
    for (const std::string& wrong : checked.wrong) std::printf("  %s\n", wrong.c_str());
    if (!checked.wrong.empty()) {
      status = check_failed;
      std::printf("  make them again by: furrow study %s --out %s\n", study->name.c_str(), options.directory.c_str());
    }
  }
  return status;
}

int study_command(const StudyOptions& options) {
  if (!options.made_by.empty()) {
    std::printf("%s\n", json_of(this_maker(that_decide(options.made_by))).dump().c_str());
    return good;
  }
  if (options.status) return print_status(studies_asked_for(options), options.directory, options.name.empty());
  if (options.check) return check_command(options);
  if (options.words) return words_command(options);
  if (options.name.empty()) {
    if (options.quick || options.anew) throw std::invalid_argument("--quick and --anew need the name of a study");
    for (const Study& study : validation::catalogue())
      std::printf("%-16s %s\n", study.name.c_str(), study.what.c_str());
    return good;
  }
  Progress progress;
  Settings settings{.quick = options.quick, .directory = options.directory};
  settings.anew = options.anew;
  settings.jobs = options.jobs > 0 ? options.jobs : processors();
  settings.progress = [&](double done, double total) { return progress.show(options.name, "running", done, total); };
  const Study& study = study_named(options.name);
  progress.begin(options.name, "running");
  if (options.few) {
    const auto say = [&](const std::string& line) {
      progress.end();
      std::printf("%s\n", line.c_str());
    };
    return validation::check_few(settings, say) ? good : check_failed;
  }
  const std::vector<std::string> refuted = run_study(study, settings, validation::catalogue());
  progress.end();
  std::printf("%s/%s.json\n", options.directory.c_str(), options.name.c_str());
  for (const std::string& claim : refuted) progress.say("furrow: does not hold: " + claim);
  return refuted.empty() ? good : check_failed;
}

int golden_command(const GoldenRequest& request) {
  Progress progress;
  validation::GoldenOptions options{.directory = request.directory, .quick = request.quick, .remake = request.remake};
  options.reason = request.reason;
  options.jobs = processors();
  options.progress = [&](double done, double total) { return progress.show("golden", "running", done, total); };
  options.say = [&](const std::string& line) {
    progress.end();
    std::printf("%s\n", line.c_str());
  };
  progress.begin("golden", "running");
  return validation::check_goldens(options) == 0 ? good : check_failed;
}

}  // namespace

void add_study_commands(CLI::App& app, std::vector<Command>& all) {
  static StudyOptions studied;
  static GoldenRequest asked;
  const auto add_study_options = [](CLI::App* command) {
    command->add_option("--out", studied.directory, "directory for NAME.json")->capture_default_str()->type_name("DIR");
    command->add_flag("--quick", studied.quick, "the short form");
    command->add_option("--jobs", studied.jobs, "runs at a time (default: one a processor)")
        ->check(whole_number(1, 1024))
        ->type_name("NUMBER");
    return command;
  };
  auto* study = add_study_options(app.add_subcommand("study", "run a study; without a name: list the studies"));
  show_examples(study, {"furrow study", "furrow study geometry --quick --out numbers",
                        "furrow study geometry --status --out reference_data/studies"});
  study->add_option("name", studied.name, "name of the study")->type_name("");
  auto* anew = study->add_flag("--anew", studied.anew, "make all numbers, those too that are kept and not old");
  auto* status = study->add_flag("--status", studied.status,
                                 "how old the numbers in --out are, and what changed since; runs nothing");
  auto* words = study->add_flag("--words", studied.words,
                                "what the page says of the numbers in --out, without figures; runs nothing");
  auto* check =
      study->add_flag("--check", studied.check, "make a sample of the cheap numbers in --out again and compare");
  auto* made_by =
      study
          ->add_option("--made-by", studied.made_by,
                       "what makes faults, judged_furrow, judged_independent, judged_others or times now: commit, "
                       "day, machine, load and sources, as JSON; runs nothing")
          ->type_name("WHAT");
  status->excludes(check)->excludes(words);
  words->excludes(check);
  for (auto* what : {status, words, check}) made_by->excludes(what);
  for (auto* what : {status, words, check, made_by}) {  // these make no numbers
    for (auto* how : {anew, study->get_option("--quick"), study->get_option("--jobs")}) what->excludes(how);
  }
  auto* ensemble = add_study_options(app.add_subcommand("ensemble", "the scenes over many packings"));
  show_examples(ensemble,
                {"furrow ensemble --quick --out numbers", "furrow ensemble --few --out reference_data/studies"});
  ensemble->add_flag("--few", studied.few, "run a few packings, compare them with the kept ensemble in --out");
  auto* statements = add_study_options(app.add_subcommand(
      "statements",
      "the paper's statements, each judged, with the numbers of ensemble, convergence and readings in --out"));
  show_examples(statements, {"furrow statements --words --out reference_data/studies"});
  auto* said =
      statements->add_flag("--words", studied.words, "what the page says of them, without figures; runs nothing");
  for (const char* how : {"--quick", "--jobs"}) said->excludes(statements->get_option(how));

  auto* golden = app.add_subcommand("golden", "run the paper's scenes and compare them to the bit with earlier runs");
  show_examples(golden, {"furrow golden --quick"});
  golden->add_option("--goldens", asked.directory, "directory of the golden outputs")
      ->capture_default_str()
      ->type_name("DIR");
  golden->add_flag("--quick", asked.quick, "scene 1 whole, the others for 0.1 s");
  golden->add_flag("--remake", asked.remake, "write those that differ again");
  golden->add_option("--reason", asked.reason, "why they are made again")->type_name("TEXT")->needs("--remake");

  all.push_back({study, [] { return study_command(studied); }});
  for (const CLI::App* named : {ensemble, statements}) {
    all.push_back({named, [named] {
                     studied.name = named->get_name();
                     return study_command(studied);
                   }});
  }
  all.push_back({golden, [] { return golden_command(asked); }});
}

}  // namespace furrow
