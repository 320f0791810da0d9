// A study is two functions: one that measures numbers, and a chapter that makes words, tables and figures from them.
// Words change without a run.
#pragma once

#include <map>
#include <set>

#include "report/age.h"
#include "report/measurement.h"

namespace furrow {

// The scene of that name in validation/scenes, wherever the program stands.
Scene scene_named(const std::string& name);

// A figure of the page: a script of validation/figures after variables and data blocks (see page/gnuplot.h).
struct Figure {
  std::string name;    // stem of its file, unlike that of any other figure
  std::string script;  // "order.gp"
  std::string caption, description;
  Json variables = Json::object();  // name: number or text
  Json blocks = Json::object();     // name: list of rows; a row is numbers and, last, perhaps a label
  std::string folded{};             // not empty: shown when opened, under this line
};

// What the numbers bear out or not: value first, then the aim, then the mark.
struct Claim {
  std::string text;          // a sentence
  std::string value, aim{};  // "3.2 times", "at least 4": what was found, what would do
  bool holds = false;
  bool timed = false;                  // rests on measured times: cannot hold by numbers older than the solver
  std::vector<std::string> numbers{};  // the keys of those that it rests on; none: all that the study keeps or reads
};

// What the first screen of the page says of a study. `tile`: the part of the page whose question it answers.
struct Headline {
  std::string tile, value, text;       // "paper", "29 of 72", "judgements of ..."
  std::vector<std::string> numbers{};  // as those of a claim
};

// What the page shows of a study, part by part. Cells of tables: numbers are shown with three digits, texts as they
// are, null and NaN as missing. All words are plain text.
class Report {
 public:
  explicit Report(std::string title, std::string question);
  Report& heading(std::string text);
  Report& text(std::string text);
  Report& table(std::string caption, std::vector<std::string> head, std::vector<std::vector<Json>> rows);
  Report& figure(Figure figure);
  Report& claim(Claim claim);
  Report& headline(Headline headline);
  Report& first_figure(const Figure& figure);  // beside the headline
  // The parts and claims of another report.
  Report& append(const Report& other);
  // What is not for the eye: all numbers behind the tables and figures.
  Report& data(Json data);
  Json json() const { return json_; }

 private:
  Json json_;
};

// The numbers of all studies, each read when it is asked for.
class Shelf {
 public:
  explicit Shelf(std::filesystem::path directory) : directory_(std::move(directory)) {}
  // Of the study. Throws FileError if there are none.
  const Numbers& of(const std::string& study) const;
  void put(Numbers numbers);

 private:
  std::filesystem::path directory_;
  mutable std::map<std::string, Numbers> read_;
};

struct Study {
  std::string name, what;
  // Its own files that decide its numbers, by the beginning of their paths.
  std::vector<std::string> files{};
  std::vector<std::string> reads{};  // other studies whose numbers its chapter needs
  void (*measure)(Measurement& measurement) = nullptr;
  Report (*chapter)(const Shelf& shelf) = nullptr;
  std::string made_by{};  // the command that makes its numbers; empty: furrow study NAME
  bool watched = false;   // its numbers say whether and why a watch ended a run

  Sources sources() const { return that_decide(sources_of_this_program(), files, watched); }
  std::string command() const { return made_by.empty() ? "furrow study " + name : made_by; }
};

// The keys of the times that a study keeps, or reads of others among `all`, and that are older than the solver.
std::set<std::string> old_times_of(const Study& study, const Shelf& shelf, const std::vector<Study>& all);

// Whether one of them is among the numbers of a claim or headline of Report::json().
bool rests_on(const Json& said, const std::set<std::string>& old_times);

// Whether a claim of Report::json() is shown today: times that are older than the solver bear nothing out.
bool holds_today(const Json& claim, const std::set<std::string>& old_times);

// Measures the study and writes settings.directory/NAME.json, sealed. Returns the claims that do not hold today, where
// those of `all` that it reads count too. Throws Interrupted.
std::vector<std::string> run_study(const Study& study, const Settings& settings, const std::vector<Study>& all = {});

// What to say where its chapter cannot be made of the numbers that are kept, and `why`: which studies it reads, what makes them.
std::string no_chapter(const Study& study, const std::string& why);

// How old the kept numbers are, with what goes into each today compared; nothing is run. `not_kept`: keys of results that
// the study would make today and that are not there.
struct AgeToday {
  Age age;
  std::vector<std::string> not_kept;
};
AgeToday age_today(const Study& study, const Numbers& kept);

// Makes a sample of the study's cheap kept numbers anew: what did not come out, a line each.
struct Checked {
  int compared = 0;
  std::vector<std::string> wrong;
};
Checked check_study(const Study& study, const std::filesystem::path& directory, std::uint64_t draw, double most_cpu);

}  // namespace furrow
